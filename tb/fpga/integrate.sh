#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# docs/integrate.md says what the RTL is; and the comparison finds what does not.
set -euo pipefail
cd "$(dirname "$0")/../.."
source tb/common/cases.sh
make -s build/fpga/top.facts
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
cp -r --parents docs/integrate.md tools/integrate_page.py tools/synth rtl "$copy"

compare() { (cd "$1" && python3 tools/integrate_page.py --check "$OLDPWD/build/fpga/top.facts" 2>&1); }
differs() { # file, sed expression, words of the message
  cp "$copy/$1" "$copy/before"
  sed -i "$2" "$copy/$1"
  local said
  if said=$(compare "$copy"); then said="nothing was found"; fi
  cp "$copy/before" "$copy/$1"
  grep -q -- "$3" <<< "$said" || { echo "$said"; return 1; }
}
case_of Integrate.SaysWhatTheRtlIs compare .
case_of Integrate.FindsAPortLess differs docs/integrate.md 's/ \.m_axi_1_rid(m_axi_1_rid),//' 'port m_axi_1_rid is missing'
case_of Integrate.FindsAPortMore differs docs/integrate.md 's/\.aclk(aclk)/&, .aclk2(aclk2)/' 'port aclk2 is not in the RTL'
case_of Integrate.FindsAParameterLess differs docs/integrate.md 's/, \.L2Kbytes(128)//' 'parameter L2Kbytes is missing'
case_of Integrate.FindsAnotherCode differs docs/integrate.md 's/^| 8 | ErrReadBus/| 9 | ErrReadBus/' 'error code ErrReadBus: 9 here, 8 in castray_pkg'
case_of Integrate.FindsAUnitLess differs docs/integrate.md '/^| isect\/shear/d' 'unit isect/shear is missing'
case_of Integrate.FindsAnotherLatency differs rtl/isect/node_pipe.sv '/^module/,$!s/7/9/g' 'unit isect/node_pipe: .*its header has no'
ends
