# SPDX-License-Identifier: Apache-2.0
# What a build is asked for: NAME=VALUE arguments, and what each board is.

# Ends the build with one line.
proc stop {message} {
  puts stderr "bitstream: $message"
  exit 1
}

# The part of a board, and the name that its board files go by whoever publishes them (avnet.com, em.avnet.com, ...).
set castray_boards {
  ultra96v1 {part xczu3eg-sbva484-1-e files ultra96v1}
  ultra96v2 {part xczu3eg-sbva484-1-i files ultra96v2}
}

# The arguments as a dictionary; every one must be there.
proc build_settings {arguments} {
  set settings {}
  foreach argument $arguments {
    if {![regexp {^([a-z0-9_]+)=(.*)$} $argument -> name value]} {
      stop "$argument is no argument of the form name=value"
    }
    dict set settings $name $value
  }
  foreach name {root out board registers clock_mhz lanes contexts tile_log2 ports l2_kbytes jobs board_files} {
    if {![dict exists $settings $name]} {
      stop "the argument $name is missing"
    }
  }
  return $settings
}

# The newest board part of a board that this Vivado knows. Board files may lie in a folder of their own.
proc board_part {board files folder} {
  if {$folder ne ""} {
    if {![file isdirectory $folder]} {
      stop "BOARD_FILES=$folder is no folder"
    }
    set_param board.repoPaths [list $folder]
  }
  set found [get_board_parts -quiet "*:$files:part0:*"]
  if {[llength $found] == 0} {
    stop "Vivado has no board files for $board. Clone Avnet's bdf repository (github.com/Avnet/bdf) and say\
      BOARD_FILES=its folder, or install them with Vivado's menu Tools, Vivado Store, Boards"
  }
  return [lindex [lsort -dictionary $found] end]
}
