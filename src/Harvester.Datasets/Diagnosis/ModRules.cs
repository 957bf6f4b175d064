namespace Harvester.Datasets.Diagnosis;

/// <summary>Problems in the mod's own log.</summary>
internal static class ModRules
{
    public static readonly IReadOnlyList<LineRule> All =
    [
        new(
            "install the latest nightly",
            "ScriptHookVDotNet does not know this build of the game.",
            "Install the latest nightly of ScriptHookVDotNet."
        ),
        new("cannot attach a camera rigidly", "The game is older than 1.0.2189 and cannot attach a camera rigidly.", "Update the game."),
        new(
            "fwScriptGuid pool is full",
            "The game's pool of script handles is full: too many mods hold entities.",
            "Restart the game, and remove mods that continually list entities."
        ),
        new(
            "settings of the game harm pictures and labels: (.+)[.] Change",
            "Settings of the game harm pictures and labels: $1.",
            "Change them under Settings, Graphics, as the table of recommended settings in docs/mod.md says."
        ),
        new(
            "no tick for ([0-9.]+) s: the game was paused[.]",
            "The game stopped for $1 s while a harvest, a drive or a plan was running.",
            "Switch off Pause Game On Focus Loss under Settings, Graphics, and do not open menus meanwhile."
        ),
        new(
            "pause game on focus loss is on",
            "The game stops while another window has the focus, so a program that drives gets no frames then.",
            "Switch off Pause Game On Focus Loss under Settings, Graphics."
        ),
        new(
            "masks come from rays: ",
            "Masks were to be photographed and come from rays instead, which are less exact.",
            "The log line says why; Masks = Rays under [Harvest] asks for them in the first place."
        ),
        new(
            "address already in use|only one usage of each socket address",
            "Another program, or another game, uses the port of the bridge.",
            "Change Port under [Bridge] in GtaDataHarvester.ini, or close the other program."
        ),
        new(
            "not enough space on the disk|no space left on device|disk is full",
            "The disk is full.",
            "Free some space, or set Folder under [Harvest] to another disk."
        ),
        new(
            "access to the path .* is denied|permission denied",
            "Windows does not allow the game to write to the folder of the sessions.",
            "Set Folder under [Harvest] to another folder, or allow the game in Windows' controlled folder access."
        ),
        new(
            "the camera model is off by",
            "The image does not fit the camera model: the lens was calibrated with other graphics settings, or never.",
            "Stand still with a free view and calibrate."
        ),
        new(
            "the camera model cannot be checked",
            "Too few calibration markers were seen.",
            "Give the camera a free view of several metres, in daylight, and start again."
        ),
        new(
            "the camera model was not checked",
            "No calibration marker was seen: something is right in front of the camera, or this game does not draw markers.",
            "Give the camera a free view and check in the report that the boxes fit, or set MaxError = 0 under [Lens]."
        ),
        new(
            "the (picture|image) is .* ticks?.* behind the game",
            "The image lags behind the game by more than the harvest allows.",
            "Raise MaxPictureLagTicks under [Harvest]; disable frame generation and other programs that delay the picture."
        ),
        new(
            "(the lag of the picture|the picture lag) could not be measured",
            "Nothing in view moved while the picture lag was measured.",
            "Drive in traffic while a harvest starts, or harvest with Mode = Freeze."
        ),
        new("the world stood still neither", "Neither freeze method stops everything.", "Remove mods that move the camera or the traffic."),
        new(
            "the road survey failed",
            "The file of the road survey, roads.csv, is damaged.",
            "Repair or move it; the log line says what is wrong."
        ),
        new("the survey of signs failed: .*row", "A row of spaces.csv is invalid.", "Correct or delete the row that the log line names."),
        new(
            "GtaDataHarvester[.]ini(: | cannot be read)",
            "A setting in GtaDataHarvester.ini is wrong; its default is used.",
            "Correct the line that the log line names, then reload the scripts."
        ),
        new(
            "the game did not (make|create) a camera",
            "The game has no scripted camera left: other mods use them all.",
            "Restart the game, and remove mods with cameras."
        ),
        new("the game has no vehicle '([^']+)'", "The game has no vehicle '$1'.", "Change Model under [TestCar] in GtaDataHarvester.ini."),
        new(
            "the game (did not load the vehicle|has no room for another vehicle)",
            "The game had no room for the test car.",
            "Try again in a moment, away from traffic."
        ),
        new(
            "Window: .*exclusive full screen",
            "The game runs in exclusive full screen, where pictures are black.",
            "Choose windowed borderless in the game's graphics settings."
        ),
        new(
            "Window: .*HDR is on",
            "HDR is on: copies of the screen may be overexposed.",
            "Switch HDR and Auto HDR off in Windows (Settings, System, Display), or run the mod's self-test, which measures the colours."
        ),
        new(
            "((The|Marking) [a-z ]+) failed: ",
            "$1 failed unexpectedly.",
            "The log says why just before that line. If it fails again, report it with the log."
        ),
        new(
            "the harvest stopped: ",
            "A harvest ended with an error.",
            "The log line says why. If it happens again, report it with the log."
        ),
    ];
}
