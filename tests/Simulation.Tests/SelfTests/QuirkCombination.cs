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

    /// <summary>Single quirks, and combinations of several.</summary>
    public static IReadOnlyDictionary<string, QuirkCombination> All { get; } =
        new Dictionary<string, QuirkCombination>
        {
            ["none"] = new(new GameQuirks(), []),
            ["hud that can be hidden"] = new(new GameQuirks { ShowsHud = true }, []),
            ["paused moves"] = new(new GameQuirks { Paused = Moving }, [SelfTestChecks.FreezePaused]),
            ["time scale moves"] = new(new GameQuirks { TimeScale = Moving }, [SelfTestChecks.FreezeTimeScale]),
            ["paused holds camera"] = new(new GameQuirks { Paused = HoldingCamera }, [SelfTestChecks.CameraPaused]),
            ["time scale holds camera"] = new(new GameQuirks { TimeScale = HoldingCamera }, [SelfTestChecks.CameraTimeScale]),
            ["paused weather"] = new(new GameQuirks { Paused = WithWeather }, [SelfTestChecks.SkyPaused]),
            ["time scale weather"] = new(new GameQuirks { TimeScale = WithWeather }, [SelfTestChecks.SkyTimeScale]),
            ["paused streams"] = new(new GameQuirks { Paused = Streaming }, [SelfTestChecks.EntitiesPaused]),
            ["time scale streams"] = new(new GameQuirks { TimeScale = Streaming }, [SelfTestChecks.EntitiesTimeScale]),
            ["lag of 2"] = new(new GameQuirks { PictureLagTicks = 2 }, [SelfTestChecks.Lag]),
            ["lag of 9"] = new(new GameQuirks { PictureLagTicks = 9 }, [SelfTestChecks.Lag]),
            ["late camera"] = new(new GameQuirks { IsCameraReportedLate = true }, [SelfTestChecks.CameraReport]),
            ["lens"] = new(new GameQuirks(), [SelfTestChecks.Lens], Bent),
            ["rays meet boxes"] = new(new GameQuirks { RaysMeetBoxes = true }, [SelfTestChecks.Rays]),
            ["late hiding"] = new(new GameQuirks { VisibilityDelayTicks = 5 }, [SelfTestChecks.HidingDelay]),
            ["nothing can be hidden"] = new(new GameQuirks { UnhideableFraction = 1 }, [SelfTestChecks.Hiding]),
            ["noise"] = new(new GameQuirks { PictureNoiseLevels = 2 }, [SelfTestChecks.Noise]),
            ["textures"] = new(new GameQuirks { TexturesMove = true }, [SelfTestChecks.Textures]),
            ["hud stays"] = new(new GameQuirks { ShowsHud = true, HudStaysWhileFrozen = true }, [SelfTestChecks.Hud]),
            ["foreign display"] = new(new GameQuirks { ShowsForeignDisplay = true }, [SelfTestChecks.Display]),
            ["overexposed"] = new(new GameQuirks { PictureGain = 1.6 }, [SelfTestChecks.Exposure]),
            ["washed out"] = new(new GameQuirks { PictureExponent = 0.7 }, [SelfTestChecks.Tones]),
            ["darkened"] = new(new GameQuirks { PictureExponent = 1.3 }, [SelfTestChecks.Tones]),
            ["scaled window"] = new(new GameQuirks { WindowScale = 1.25 }, [SelfTestChecks.Scale]),
            ["other window"] = new(new GameQuirks { ShowsOtherWindow = true }, [SelfTestChecks.Window]),
            ["few markers"] = new(new GameQuirks { MaxMarkers = 64 }, [SelfTestChecks.Markers]),
            ["wide extents"] = new(new GameQuirks { ModelMarginMetres = 0.3 }, [SelfTestChecks.Dimensions]),
            ["no materials"] = new(new GameQuirks { HidesMaterials = true }, [SelfTestChecks.Materials]),
            ["level of detail"] = new(new GameQuirks { DetailChangesAfterTicks = 30 }, [SelfTestChecks.LevelOfDetail]),
            ["hud stays, lag, time scale moves"] = new(
                new GameQuirks
                {
                    ShowsHud = true,
                    HudStaysWhileFrozen = true,
                    PictureLagTicks = 2,
                    TimeScale = Moving,
                },
                [SelfTestChecks.Hud, SelfTestChecks.Lag, SelfTestChecks.FreezeTimeScale]
            ),
            ["overexposed, boxes, no materials"] = new(
                new GameQuirks
                {
                    PictureGain = 1.6,
                    RaysMeetBoxes = true,
                    HidesMaterials = true,
                },
                [SelfTestChecks.Exposure, SelfTestChecks.Rays, SelfTestChecks.Materials]
            ),
            ["display, late hiding, paused weather"] = new(
                new GameQuirks
                {
                    ShowsForeignDisplay = true,
                    VisibilityDelayTicks = 4,
                    Paused = WithWeather,
                },
                [SelfTestChecks.Display, SelfTestChecks.HidingDelay, SelfTestChecks.SkyPaused]
            ),
            ["few markers, washed out, lag"] = new(
                new GameQuirks
                {
                    MaxMarkers = 64,
                    PictureExponent = 0.7,
                    PictureLagTicks = 3,
                },
                [SelfTestChecks.Markers, SelfTestChecks.Tones, SelfTestChecks.Lag]
            ),
            ["noise, late camera, time scale holds camera"] = new(
                new GameQuirks
                {
                    PictureNoiseLevels = 2,
                    IsCameraReportedLate = true,
                    TimeScale = HoldingCamera,
                },
                [SelfTestChecks.Noise, SelfTestChecks.CameraReport, SelfTestChecks.CameraTimeScale]
            ),
            ["scaled window, paused moves"] = new(
                new GameQuirks { WindowScale = 1.5, Paused = Moving },
                [SelfTestChecks.Scale, SelfTestChecks.FreezePaused]
            ),
            ["both methods creep"] = new(
                new GameQuirks { Paused = Creeping, TimeScale = Creeping },
                [SelfTestChecks.FreezePaused, SelfTestChecks.FreezeTimeScale]
            ),
        };
}
