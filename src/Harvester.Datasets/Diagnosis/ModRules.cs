using System.Collections.Generic;

namespace Harvester.Datasets.Diagnosis;

/// <summary>What the mod's own log tells of problems.</summary>
internal static class ModRules
{
    public static readonly IReadOnlyList<LineRule> All =
    [
        new(
            "install the latest nightly",
            "ScriptHookVDotNet does not know this build of the game.",
            "Install the latest nightly of ScriptHookVDotNet."),
        new(
            "cannot attach a camera rigidly",
            "The game is older than 1.0.2189 and cannot attach a camera rigidly.",
            "Update the game."),
        new(
            "fwScriptGuid pool is full",
            "The game's pool of script handles is full: too many mods hold entities.",
            "Restart the game, and remove mods that list entities all the time."),
        new(
            "address already in use|only one usage of each socket address",
            "Another program, or another game, uses the port of the bridge.",
            "Change Port under [Bridge] in GtaDataHarvester.ini, or end the other program."),
        new(
            "not enough space on the disk|no space left on device|disk is full",
            "The disk is full.",
            "Free some space, or set Folder under [Harvest] to another disk."),
        new(
            "access to the path .* is denied|permission denied",
            "Windows does not let the game write where the sessions go.",
            "Set Folder under [Harvest] to a folder of yours, or allow the game in Windows' controlled folder access."),
        new(
            "the camera model is off by",
            "The image does not fit the camera model: the lens was calibrated with other graphics settings, or never.",
            "Stand still with a free view and calibrate."),
        new(
            "the camera model cannot be checked",
            "Too few calibration markers were seen.",
            "Give the camera a free view of some metres, by day, and start again."),
        new(
            "the camera model was not checked",
            "No calibration marker was seen: something stands right before the camera, or this game does not draw markers.",
            "Give the camera a free view; look in the report whether the boxes fit, or set MaxError = 0 under [Lens]."),
        new(
            "the picture is .* ticks.* behind the game",
            "The picture is later than the harvest allows.",
            "Raise MaxPictureLagTicks under [Harvest]; switch frame generation and other programs that delay the picture off."),
        new(
            "(the lag of the picture|the picture lag) could not be measured",
            "Nothing moved in view while the lag of the picture was measured.",
            "Drive on among traffic while a harvest starts, or harvest with Mode = Freeze."),
        new(
            "the world stood still neither",
            "Neither way of freezing the game stops everything.",
            "Remove mods that move the camera or the traffic."),
        new(
            "the road survey failed",
            "The file of the road survey, roads.csv, is damaged.",
            "Repair it or move it away; the log line says what is wrong with it."),
        new(
            "the survey of signs failed: .*row",
            "A row of your spaces.csv cannot be read.",
            "Correct or delete the row that the log line names."),
        new(
            "GtaDataHarvester[.]ini(: | cannot be read)",
            "A setting in GtaDataHarvester.ini is wrong; its default is used.",
            "Correct the line that the log line names, then reload the scripts."),
        new(
            "the game did not (make|create) a camera",
            "The game has no scripted camera left: other mods hold them.",
            "Restart the game, and remove mods with cameras."),
        new(
            "the game has no vehicle '([^']+)'",
            "The game has no vehicle '$1'.",
            "Change Model under [TestCar] in GtaDataHarvester.ini."),
        new(
            "the game (did not load the vehicle|has no room for another vehicle)",
            "The game had no room for the test car.",
            "Try again in a moment, away from traffic."),
        new(
            "Window: .*exclusive full screen",
            "The game runs in exclusive full screen, where pictures are black.",
            "Choose windowed borderless in the game's graphics settings."),
        new(
            "((The|Marking) [a-z ]+) failed: ",
            "$1 failed unexpectedly.",
            "The log says why just before that line. If it fails again, report it with the log."),
        new(
            "the harvest stopped: ",
            "A harvest was ended by a failure.",
            "The log line says why. If it happens again, report it with the log."),
    ];
}
