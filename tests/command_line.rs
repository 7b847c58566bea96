//! Tests of the real command in an empty folder: its output, its exit codes, and every byte that it writes.

#![allow(clippy::unwrap_used)] // a test that cannot set up its folder fails

mod command_line {
    mod answers;
    mod audit;
    mod cache;
    mod ci_example;
    mod commands;
    mod completions;
    mod demo;
    mod determinism;
    mod diff;
    mod draw;
    mod edits;
    mod faults;
    mod flats;
    mod former_levels;
    mod guide;
    mod handbook;
    mod honeybee;
    mod hostile_words;
    mod ifc;
    mod indoor;
    mod init;
    mod level_lists;
    mod looks;
    mod navigation;
    mod output_folder;
    mod pinned;
    mod plan;
    mod readme;
    mod recipe;
    mod schemas;
    mod sweet_home;
    mod tiles;
    mod unknown_words;
    mod user_models;
    mod verdicts;
    mod view;
    mod walk;
    mod watch;
    mod world;
}
