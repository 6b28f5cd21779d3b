# SPDX-License-Identifier: Apache-2.0
# The board's side of the host, for its processor: the model, the driver and the device layer behind UIO, with Debian's
# cross compiler and the standard library alone.
BOARD_SOURCES := sim/castray_board.cpp sim/driver.cpp sim/model_device.cpp $(wildcard sim/uio/*.cpp) $(wildcard cpp_model/*.cpp) \
                 $(addprefix cpp_model/scene/,scene_image.cpp files.cpp replacement.cpp)

$(BUILD)/castray_board: $(BOARD_SOURCES:%.cpp=$(BUILD)/obj/%.o)
	@echo "  LINK  castray_board"
	@$(CXX) $^ -o $@ -latomic -lpthread

ARM64_CXX     := aarch64-linux-gnu-g++
ARM64_OBJECTS := $(BOARD_SOURCES:%.cpp=$(BUILD)/arm64/obj/%.o)
$(BUILD)/arm64/obj/%.o: %.cpp $(RECORDS)
	@mkdir -p $(@D)
	@echo "  ARM64 $<"
	@$(ARM64_CXX) -std=c++20 -O2 -mcpu=cortex-a53 -Wall -Wextra -Wno-unused-parameter -Wno-missing-field-initializers -MMD -MP -Icpp_model -Isim -I$(BUILD)/gen -c $< -o $@
# Static: the board's libraries need not be those of the compiler.
$(BUILD)/arm64/castray_board: $(ARM64_OBJECTS)
	@echo "  LINK  arm64/castray_board"
	@$(ARM64_CXX) -static $^ -o $@ -lpthread

# tb/cli/arm64.sh runs both.
tests: $(BUILD)/castray_board $(BUILD)/arm64/castray_board

.PHONY: arm64
arm64: $(BUILD)/arm64/castray_board ## cross-compile the program for the board: build/arm64/castray_board
-include $(ARM64_OBJECTS:.o=.d) $(BUILD)/obj/sim/castray_board.d
