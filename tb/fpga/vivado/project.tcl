# SPDX-License-Identifier: Apache-2.0
# Projects, their files and their boards.
namespace eval fake {
  variable project ""
  variable parts {xczu3eg-sbva484-1-e xczu3eg-sbva484-1-i}
  variable parameters {board.repoPaths {}}

  class project {board_part {} ip_repo_paths {}} {part {} folder {}}
  class fileset {top {}}
  class file {} {path {}}

  proc environment {name default} {
    return [expr {[info exists ::env($name)] ? $::env($name) : $default}]
  }

  proc open_project {} {
    variable project
    if {$project eq ""} {
      fail "no project is open"
    }
    return $project
  }

  proc project_file {args} {
    return [file join [value [open_project] folder] {*}$args]
  }

  command version {-short} {} {
    return [environment FAKE_VERSION 2023.2]
  }

  command set_param {} {name value} {
    variable parameters
    if {![dict exists $parameters $name]} {
      fail "set_param: no parameter $name"
    }
    dict set parameters $name $value
  }

  command create_project {-force -part:} {name folder} {
    variable project
    variable parts
    if {$project ne ""} {
      fail "create_project: [name_of $project] is open"
    }
    if {[dict get $option -part] ni $parts} {
      fail "create_project: no part [dict get $option -part]"
    }
    if {[file exists [file join $folder $name.xpr]] && ![dict exists $option -force]} {
      fail "create_project: $folder holds a project"
    }
    file delete -force $folder
    file mkdir $folder
    close [open [file join $folder $name.xpr] w]
    set project [create project $name [dict create part [dict get $option -part] folder $folder]]
    create fileset sources_1
    create_runs
  }

  command close_project {} {} {
    variable project
    variable objects
    open_project
    set project ""
    set objects {}
  }

  command current_project {} {} {
    return [open_project]
  }

  command current_fileset {} {} {
    open_project
    return fileset:sources_1
  }

  command add_files {-norecurse} {files*} {
    open_project
    foreach file [concat {*}$files] {
      need_file $file
      create file [file tail $file] [dict create path [file normalize $file]]
    }
  }

  command get_files {-quiet} {pattern} {
    return [find file $pattern [quiet $option]]
  }

  command update_compile_order {-fileset:} {} {
    find fileset [dict get $option -fileset]
    need_top
  }

  # The top must be a module of one of the files.
  proc need_top {} {
    set top [value fileset:sources_1 top]
    foreach file [find file * 1] {
      set text [open [value $file path]]
      set is_there [regexp "\\mmodule\\s+$top\\M" [read $text]]
      close $text
      if {$is_there} {
        return $top
      }
    }
    fail "no file has the module '$top'"
  }

  on_change project board_part {
    if {$value ni [installed_boards]} {
      fail "set_property board_part: no board $value"
    }
    set board [dict get {xczu3eg-sbva484-1-e ultra96v1 xczu3eg-sbva484-1-i ultra96v2} [value $object part]]
    if {![string match "*:$board:*" $value]} {
      fail "board $value does not have the part [value $object part]"
    }
  }

  proc installed_boards {} {
    return [environment FAKE_BOARDS {avnet.com:ultra96v1:part0:1.1 avnet.com:ultra96v1:part0:1.2 avnet.com:ultra96v2:part0:1.2}]
  }

  command get_board_parts {-quiet} {pattern} {
    variable parameters
    set found [lsearch -all -inline -glob [installed_boards] $pattern]
    foreach folder [dict get $parameters board.repoPaths] {
      need_file $folder
    }
    if {[llength $found] == 0 && ![quiet $option]} {
      fail "get_board_parts: none matches $pattern"
    }
    return $found
  }
}
