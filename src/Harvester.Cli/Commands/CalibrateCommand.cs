using System.CommandLine;
using Harvester.Capture.Calibration;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;
using Harvester.Simulation.Game;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;

namespace Harvester.Cli.Commands;

/// <summary>harvester calibrate: runs the calibration of the mod on the simulated game.</summary>
internal static class CalibrateCommand
{
    private const double SecondsPerTick = 1 / 30.0;
    private const int MaxTicks = 10_000;

    // The markers of a calibration, 11 rows of 15, must be 3 radii apart and 3 radii from the edges; smaller images have no room.
    private const int MinWidth = 288;
    private const int MinHeight = 216;
    private const int MaxSide = 8192;

    private const string Notes =
        "The options describe the lens of the simulated game. The calibration does not see them: it draws markers at known positions and\n"
        + "measures the lens from the images alone. It prints the measured lens, as lines for the mod's ini file, and the errors before\n"
        + "and after.\n\n"
        + "Example:\n"
        + "  harvester calibrate --focal-scale 1.008 --k1 -0.02 --size 1920x1080 --fov 90";

    public static Command Create(Terminal terminal)
    {
        Option<int> seed = ValueParsers.Integer("--seed", "N", "Random seed of the simulated town [default: 0]", 0, int.MaxValue);
        Option<double> fov = CameraOptions.Fov();
        fov.DefaultValueFactory = _ => new SimulationOptions().VerticalFovDegrees;
        Option<ImageSize> size = ValueParsers.Size(
            "--size",
            "Width and height of the images, pixels",
            new ImageSize(MinWidth, MinHeight),
            MaxSide
        );
        size.DefaultValueFactory = _ => new CalibrationOptions().Image;
        var lens = new LensOptions();
        Option<double> threshold = ValueParsers.Number(
            "--threshold",
            "PX",
            "Maximum error, pixels",
            value => value > 0,
            "a number greater than 0"
        );
        threshold.DefaultValueFactory = _ => new CalibrationOptions().ThresholdPixels;
        var command = new ResultCommand(
            "calibrate",
            "Measure the lens of the simulated game from markers in its images, as the mod does in GTA V."
        )
        {
            seed,
            fov,
            size,
            threshold,
        };
        lens.AddNumbersTo(command);
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(parsed =>
        {
            ImageSize image = parsed.GetValue(size);
            Lens injected = lens.Parse(parsed);
            var game = new SimulatedGame(
                new SimulationOptions
                {
                    Seed = parsed.GetValue(seed),
                    VerticalFovDegrees = parsed.GetValue(fov),
                    WindowAspect = image.Aspect,
                    Lens = new RenderLens(injected.FocalScale, injected.CentreOffsetX, injected.CentreOffsetY, injected.K1, injected.K2),
                }
            );
            return Run(game, new CalibrationOptions { Image = image, ThresholdPixels = parsed.GetValue(threshold) }, terminal);
        });
        return command;
    }

    private static int Run(SimulatedGame game, CalibrationOptions options, Terminal terminal)
    {
        using var session = new CalibrationSession(options, game.Ports);
        for (int tick = 0; tick < MaxTicks && session.Step() == CalibrationPhase.Settling; tick++)
        {
            game.Tick(SecondsPerTick);
        }

        if (session.Result is not { } result)
        {
            terminal.WriteError(session.Fault ?? "The calibration did not finish.");
            return ExitCode.HarvestFault;
        }

        Write(result, terminal.Out);
        return ExitCode.Done;
    }

    private static void Write(CalibrationResult result, TextWriter output)
    {
        Lens lens = result.Lens;
        WriteLine($"; {result.After.Count} of {result.Shown} markers used, {result.Outliers} outliers excluded");
        WriteLine($"; before: {result.Before.RmsPixels:0.000} px RMS, {result.Before.MaxPixels:0.000} px max");
        WriteLine($"; after:  {result.After.RmsPixels:0.000} px RMS, {result.After.MaxPixels:0.000} px max");
        ReprojectionError check = result.Validation;
        WriteLine(
            $"; check:  {check.RmsPixels:0.000} px RMS, {check.MaxPixels:0.000} px max, on {check.Count} markers not used for the fit"
        );
        WriteLine($"; uncertainty at the corners: {result.UncertaintyPixels:0.000} px (95 % confidence)");
        WriteLine($"FocalScale = {lens.FocalScale:0.000000}");
        WriteLine($"CentreOffsetX = {WithoutMinusZero(lens.CentreOffsetX):0.000000}");
        WriteLine($"CentreOffsetY = {WithoutMinusZero(lens.CentreOffsetY):0.000000}");
        WriteLine($"K1 = {WithoutMinusZero(lens.K1):0.000000}");
        WriteLine($"K2 = {WithoutMinusZero(lens.K2):0.000000}");
        void WriteLine(FormattableString line) => output.WriteLine(FormattableString.Invariant(line));
    }

    private static double WithoutMinusZero(double value) => Math.Round(value, 6) + 0.0;
}
