using Harvester.Sessions.SelfTests;

namespace Harvester.Datasets.Diagnosis;

/// <summary>What to do about the findings of a self-test.</summary>
internal static class SelfTestRules
{
    private const string OtherFreeze = "Set Freeze under [Harvest] to the other method, or leave it at Auto, which tries both.";
    private const string RemoveMods = "Remove mods that create, move or delete vehicles or people. " + OtherFreeze;

    private static readonly Dictionary<string, string> Advice = new()
    {
        [SelfTestChecks.Window] =
            "Choose windowed borderless in the game's graphics settings, and close programs that copy the game's name.",
        [SelfTestChecks.Scale] = "In the properties of GTA5.exe, under Compatibility, override the scaling behaviour: Application.",
        [SelfTestChecks.Exposure] =
            "Switch HDR and Auto HDR off in Windows: Settings, System, Display, Graphics. Pictures that were taken so are overexposed.",
        [SelfTestChecks.Tones] = "Switch off colour filters, night light, driver filters and injectors such as ReShade or an ENB.",
        [SelfTestChecks.FreezePaused] = OtherFreeze,
        [SelfTestChecks.FreezeTimeScale] = OtherFreeze,
        [SelfTestChecks.EntitiesPaused] = RemoveMods,
        [SelfTestChecks.EntitiesTimeScale] = RemoveMods,
        [SelfTestChecks.SkyPaused] = OtherFreeze,
        [SelfTestChecks.SkyTimeScale] = OtherFreeze,
        [SelfTestChecks.CameraPaused] = OtherFreeze + " Rigs and pairs need a camera that moves in the frozen world.",
        [SelfTestChecks.CameraTimeScale] = OtherFreeze + " Rigs and pairs need a camera that moves in the frozen world.",
        [SelfTestChecks.Lag] =
            "Harvests with Mode = Freeze allow for it. If it exceeds MaxPictureLagTicks, raise that, or switch frame generation off.",
        [SelfTestChecks.CameraReport] = "Nothing: harvests allow for it.",
        [SelfTestChecks.Hud] = "Switch the radar and the HUD off in the game's settings, under Display.",
        [SelfTestChecks.Display] = "Close the program, or switch off the mod's display, that draws there.",
        [SelfTestChecks.Noise] = "Switch film grain and MSAA off in the graphics settings. Masks from photographs allow for noise.",
        [SelfTestChecks.Textures] = "Nothing for boxes. Masks from photographs may lack pixels there.",
        [SelfTestChecks.LevelOfDetail] =
            "Raise Extended Distance Scaling, or stand for a while before each frame: photographs of one moment differ there.",
        [SelfTestChecks.Markers] =
            "Give the camera a free view. If the game draws fewer markers than asked, calibrate with a narrower view.",
        [SelfTestChecks.Lens] = "Nothing if the mod wrote the lens into the ini; otherwise calibrate with NumPad1.",
        [SelfTestChecks.Hiding] = "Set Masks = Rays: masks from photographs need objects that can be hidden.",
        [SelfTestChecks.HidingDelay] = "Nothing: masks from photographs wait for it.",
        [SelfTestChecks.Rays] = "Set Masks = Coded: rays meet the collision hulls of this game, not what is drawn.",
        [SelfTestChecks.Dimensions] = "Use the visible boxes (--boxes visible): cuboids are larger than what is drawn.",
        [SelfTestChecks.Materials] = "Set Semantics = Off: class maps need materials.",
    };

    /// <summary>The findings for the checks with a problem.</summary>
    public static IEnumerable<Finding> Of(SelfTestFile test, string name)
    {
        foreach (SelfTestLine line in test.Lines.Where(line => line.Verdict == SelfTestVerdict.Problem))
        {
            yield return new Finding(line.Sentence, AdviceFor(line.Check), new LogLine(name, null, line.Check));
        }

        if (!test.IsComplete)
        {
            yield return new Finding("The self-test was stopped before its end.", "Run it again.");
        }
    }

    /// <summary>What to do about a finding of a check.</summary>
    public static string AdviceFor(string check) => Advice.TryGetValue(check, out string? advice) ? advice : "Report it with this file.";
}
