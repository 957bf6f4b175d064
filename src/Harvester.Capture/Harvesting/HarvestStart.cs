using Harvester.Capture.Faults;
using Harvester.Capture.Ports;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// What a harvest checks and measures once, before its first frame. Each finding is null until it is known, and if it was not looked for.
/// </summary>
/// <param name="options">What to check.</param>
/// <param name="game">The game.</param>
/// <param name="reader">Reads the scene.</param>
/// <param name="pool">Buffers for pictures.</param>
/// <param name="open">Opens the session: after the checks, before the lag is measured.</param>
internal sealed class HarvestStart(HarvestOptions options, GamePorts game, SceneReader reader, PixelBufferPool pool, Action open)
{
    private static readonly CaptureFault LagUnchecked = new(
        FaultCode.LagUnchecked,
        "The picture lag was not checked: neither markers nor movement showed it. Check that the boxes align with moving objects."
    );

    /// <summary>The freeze methods that were tried, here or earlier in the same session.</summary>
    public FreezeReport? Freezing { get; private set; }

    /// <summary>Whether the game's display can be hidden while it is frozen.</summary>
    public DisplayFinding? Display { get; private set; }

    /// <summary>How pictures show known colours.</summary>
    public ColourFinding? Colours { get; private set; }

    /// <summary>Error of the camera model, pixels.</summary>
    public double? CalibrationErrorPixels { get; private set; }

    /// <summary>The picture lag.</summary>
    public PictureLag? Lag { get; private set; }

    /// <summary>What could not be checked; empty until the end.</summary>
    public IReadOnlyList<CaptureFault> Unchecked { get; private set; } = [];

    /// <summary>Checks and measures, over several ticks.</summary>
    public IEnumerable<WorkStep> Run()
    {
        var freeze = new FreezeProbe(options, game, reader, pool);
        yield return HarvestPhase.MeasuringFreeze.Do(freeze.Choose());

        Freezing = freeze.Report;
        var display = new DisplayProbe(options, game, pool);
        yield return HarvestPhase.CheckingDisplay.Do(display.Run());

        Display = display.Finding;
        var colours = new ColourProbe(options, game, pool);
        yield return HarvestPhase.CheckingDisplay.Do(colours.Run());

        Colours = colours.Finding;
        var check = new CalibrationCheck(options, game);
        yield return HarvestPhase.CheckingCalibration.Do(check.Run());

        CalibrationErrorPixels = check.ErrorPixels;
        open();
        yield return HarvestPhase.Probing.Do(FindLag());

        bool isLagOpen = Lag is null && check.ErrorPixels is null && (options.ProbeLag || check.Warning is not null);
        CaptureFault?[] warnings = [freeze.Warning, display.Warning, colours.Warning, check.Warning, isLagOpen ? LagUnchecked : null];
        Unchecked = [.. warnings.OfType<CaptureFault>()];
    }

    private IEnumerable<WorkStep> FindLag()
    {
        if (!options.Freeze && options.LiveLag is { } known)
        {
            Lag = known;
        }
        else if (options.ProbeLag)
        {
            var probe = new LagProbe(options, game, reader, pool) { IsLagWithinLimit = CalibrationErrorPixels is not null };
            yield return WorkStep.Do(probe.Measure(options.Freeze));

            Lag = probe.Lag;
        }
    }
}
