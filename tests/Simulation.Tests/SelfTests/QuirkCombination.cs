using Harvester.Sessions.SelfTests;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests.SelfTests;

/// <summary>Quirks of the simulated game, and the checks of the self-test that must find them.</summary>
/// <param name="Quirks">The quirks.</param>
/// <param name="Checks">The checks.</param>
/// <param name="Lens">The lens of the game.</param>
internal sealed record QuirkCombination(GameQuirks Quirks, string[] Checks, RenderLens? Lens = null)
{
    private static readonly FreezeQuirks Moving = new() { NeverStands = true };
    private static readonly FreezeQuirks HoldingCamera = new() { HoldsCamera = true };
    private static readonly FreezeQuirks WithWeather = new() { LetsWeatherGoOn = true };
    private static readonly FreezeQuirks Streaming = new() { ChangesVisibility = true };
    private static readonly FreezeQuirks Creeping = new() { CreepTicks = 12 };
    private static readonly RenderLens Bent = new(1.03, 0.01, -0.02, -0.05, 0.01);

    /// <summary>No quirk, and one that does no harm.</summary>
    public static IReadOnlyDictionary<string, QuirkCombination> Harmless { get; } =
        new Dictionary<string, QuirkCombination>
        {
            ["none"] = new(new GameQuirks(), []),
            ["hud that can be hidden"] = new(new GameQuirks { ShowsHud = true }, []),
        };

    /// <summary>Single quirks, each with the check that finds it.</summary>
    private static readonly Dictionary<string, (Func<GameQuirks, GameQuirks> Add, string Check)> Faults = new()
    {
        ["paused moves"] = (quirks => quirks with { Paused = Moving }, SelfTestChecks.FreezePaused),
        ["time scale moves"] = (quirks => quirks with { TimeScale = Moving }, SelfTestChecks.FreezeTimeScale),
        ["paused creeps"] = (quirks => quirks with { Paused = Creeping }, SelfTestChecks.FreezePaused),
        ["time scale creeps"] = (quirks => quirks with { TimeScale = Creeping }, SelfTestChecks.FreezeTimeScale),
        ["paused holds camera"] = (quirks => quirks with { Paused = HoldingCamera }, SelfTestChecks.CameraPaused),
        ["time scale holds camera"] = (quirks => quirks with { TimeScale = HoldingCamera }, SelfTestChecks.CameraTimeScale),
        ["paused weather"] = (quirks => quirks with { Paused = WithWeather }, SelfTestChecks.SkyPaused),
        ["time scale weather"] = (quirks => quirks with { TimeScale = WithWeather }, SelfTestChecks.SkyTimeScale),
        ["paused streams"] = (quirks => quirks with { Paused = Streaming }, SelfTestChecks.EntitiesPaused),
        ["time scale streams"] = (quirks => quirks with { TimeScale = Streaming }, SelfTestChecks.EntitiesTimeScale),
        ["lag of 2"] = (quirks => quirks with { PictureLagTicks = 2 }, SelfTestChecks.Lag),
        ["lag of 9"] = (quirks => quirks with { PictureLagTicks = 9 }, SelfTestChecks.Lag),
        ["late camera"] = (quirks => quirks with { IsCameraReportedLate = true }, SelfTestChecks.CameraReport),
        ["rays meet boxes"] = (quirks => quirks with { RaysMeetBoxes = true }, SelfTestChecks.Rays),
        ["late hiding"] = (quirks => quirks with { VisibilityDelayTicks = 5 }, SelfTestChecks.HidingDelay),
        ["nothing can be hidden"] = (quirks => quirks with { UnhideableFraction = 1 }, SelfTestChecks.Hiding),
        ["noise"] = (quirks => quirks with { PictureNoiseLevels = 2 }, SelfTestChecks.Noise),
        ["textures"] = (quirks => quirks with { TexturesMove = true }, SelfTestChecks.Textures),
        ["hud stays"] = (quirks => quirks with { ShowsHud = true, HudStaysWhileFrozen = true }, SelfTestChecks.Hud),
        ["foreign display"] = (quirks => quirks with { ShowsForeignDisplay = true }, SelfTestChecks.Display),
        ["overexposed"] = (quirks => quirks with { PictureGain = 1.6 }, SelfTestChecks.Exposure),
        ["washed out"] = (quirks => quirks with { PictureExponent = 0.7 }, SelfTestChecks.Tones),
        ["darkened"] = (quirks => quirks with { PictureExponent = 1.3 }, SelfTestChecks.Tones),
        ["scaled window"] = (quirks => quirks with { WindowScale = 1.25 }, SelfTestChecks.Scale),
        ["other window"] = (quirks => quirks with { ShowsOtherWindow = true }, SelfTestChecks.Window),
        ["few markers"] = (quirks => quirks with { MaxMarkers = 64 }, SelfTestChecks.Markers),
        ["wide extents"] = (quirks => quirks with { ModelMarginMetres = 0.3 }, SelfTestChecks.Dimensions),
        ["no materials"] = (quirks => quirks with { HidesMaterials = true }, SelfTestChecks.Materials),
        ["level of detail"] = (quirks => quirks with { DetailChangesAfterTicks = 30 }, SelfTestChecks.LevelOfDetail),
    };

    /// <summary>Each quirk alone.</summary>
    public static IReadOnlyDictionary<string, QuirkCombination> Single { get; } =
        Faults
            .ToDictionary(fault => fault.Key, fault => new QuirkCombination(fault.Value.Add(new GameQuirks()), [fault.Value.Check]))
            .Append(new("lens", new QuirkCombination(new GameQuirks(), [SelfTestChecks.Lens], Bent)))
            .ToDictionary(StringComparer.Ordinal);

    /// <summary>Several quirks at once.</summary>
    public static IReadOnlyDictionary<string, QuirkCombination> Combined { get; } =
        new[]
        {
            "hud stays, lag of 2, time scale moves",
            "overexposed, rays meet boxes, no materials",
            "foreign display, late hiding, paused weather",
            "few markers, washed out, lag of 2",
            "noise, late camera, time scale holds camera",
            "scaled window, paused moves",
            "paused creeps, time scale creeps",
            "time scale moves, lag of 9",
            "time scale weather, rays meet boxes",
            "time scale streams, no materials, few markers",
            "paused holds camera, wide extents",
            "paused streams, lag of 2",
            "paused moves, washed out, rays meet boxes",
            "time scale creeps, overexposed",
            "late camera, lag of 2",
            "late camera, few markers, no materials",
            "late hiding, lag of 2",
            "late hiding, rays meet boxes, time scale weather",
            "nothing can be hidden, few markers",
            "nothing can be hidden, time scale moves, no materials",
            "noise, rays meet boxes",
            "noise, few markers, time scale weather",
            "textures, no materials",
            "textures, lag of 2, few markers",
            "hud stays, few markers",
            "hud stays, overexposed, rays meet boxes",
            "foreign display, time scale holds camera",
            "foreign display, darkened",
            "darkened, wide extents, no materials",
            "scaled window, no materials, time scale streams",
            "wide extents, lag of 2, time scale weather",
            "level of detail, rays meet boxes",
            "level of detail, lag of 2, no materials",
            "paused weather, time scale holds camera, rays meet boxes",
        }.ToDictionary(names => names, Of, StringComparer.Ordinal);

    /// <summary>All of these.</summary>
    public static IReadOnlyDictionary<string, QuirkCombination> All { get; } =
        Harmless.Concat(Single).Concat(Combined).ToDictionary(StringComparer.Ordinal);

    private static QuirkCombination Of(string names)
    {
        (Func<GameQuirks, GameQuirks> Add, string Check)[] faults = [.. names.Split(", ").Select(name => Faults[name])];
        return new(faults.Aggregate(new GameQuirks(), (quirks, fault) => fault.Add(quirks)), [.. faults.Select(fault => fault.Check)]);
    }
}
