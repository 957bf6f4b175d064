namespace Harvester.Runs.Evaluation.Figures;

/// <summary>
/// The figures of a drive. What the built-in driver drives, in junctions and where it gives way, does not count for the controller.
/// </summary>
public sealed record DriveFigures
{
    private const int Decimals = 4;

    /// <summary>Duration, seconds of game time.</summary>
    public required double Seconds { get; init; }

    /// <summary>Distance driven, metres.</summary>
    public required double Metres { get; init; }

    /// <summary>Distance driven by the controller, metres.</summary>
    public required double ControllerMetres { get; init; }

    /// <summary>Distance driven by the controller outside junctions, where lane keeping is evaluated, metres.</summary>
    public required double JudgedMetres { get; init; }

    /// <summary>Mean speed while the controller drives, m/s.</summary>
    public required double ControllerMeanSpeed { get; init; }

    /// <summary>Number of lane departures by the controller, outside junctions.</summary>
    public required int LaneDepartures { get; init; }

    /// <summary>Number of lane changes by the controller.</summary>
    public required int LaneChanges { get; init; }

    /// <summary>Root mean square of the lateral error, metres, without samples around lane changes.</summary>
    public required double RmsLateralError { get; init; }

    /// <summary>Largest lateral error, metres, without samples around lane changes.</summary>
    public required double LargestLateralError { get; init; }

    /// <summary>Number of vehicles that the controller hit outside junctions.</summary>
    public required int Collisions { get; init; }

    /// <summary>Number of vehicles that the controller hit in junctions.</summary>
    public required int CollisionsInJunctions { get; init; }

    /// <summary>Number of vehicles that the built-in driver hit outside junctions.</summary>
    public required int CollisionsOfOwnDriver { get; init; }

    /// <summary>Number of vehicles that the built-in driver hit in junctions.</summary>
    public required int CollisionsOfOwnDriverInJunctions { get; init; }

    /// <summary>Root mean square of the longitudinal jerk while the controller drives, m/s³.</summary>
    public required double RmsJerk { get; init; }

    /// <summary>Number of times the car was repositioned: at the end of the roads, when stuck, or for another start.</summary>
    public required int Relocations { get; init; }

    /// <summary>Computes the figures of samples taken at equal intervals.</summary>
    public static DriveFigures Of(IReadOnlyList<DriveSample> samples)
    {
        ArgumentNullException.ThrowIfNull(samples);
        var keeping = new LaneKeeping(samples);
        double[] errors = [.. keeping.LateralErrors()];
        double seconds = 0;
        double metres = 0;
        double controllerSeconds = 0;
        double controllerMetres = 0;
        double judgedMetres = 0;
        for (int i = 1; i < samples.Count; i++)
        {
            if (samples[i].IsTeleported)
            {
                continue;
            }

            double way = (samples[i].Position - samples[i - 1].Position).Length;
            double time = samples[i].TimeSeconds - samples[i - 1].TimeSeconds;
            seconds += time;
            metres += way;
            if (samples[i].IsByController)
            {
                controllerSeconds += time;
                controllerMetres += way;
                judgedMetres += samples[i].Lane is null ? 0 : way;
            }
        }

        ILookup<(bool ByController, bool InJunction), int> collisions = Evaluation
            .Figures.Collisions.In(samples)
            .ToLookup(i => (samples[i].IsByController, samples[i].Lane is null));
        return new DriveFigures
        {
            Seconds = Rounded(seconds),
            Metres = Rounded(metres),
            ControllerMetres = Rounded(controllerMetres),
            JudgedMetres = Rounded(judgedMetres),
            ControllerMeanSpeed = controllerSeconds > 0 ? Rounded(controllerMetres / controllerSeconds) : 0,
            LaneDepartures = keeping.Departures.Count,
            LaneChanges = keeping.Changes,
            RmsLateralError = Rounded(RootMeanSquare(errors)),
            LargestLateralError = errors.Length > 0 ? Rounded(errors.Max(Math.Abs)) : 0,
            Collisions = collisions[(true, false)].Count(),
            CollisionsInJunctions = collisions[(true, true)].Count(),
            CollisionsOfOwnDriver = collisions[(false, false)].Count(),
            CollisionsOfOwnDriverInJunctions = collisions[(false, true)].Count(),
            RmsJerk = Rounded(RootMeanSquare([.. Jerk.Of(samples).Select(at => at.Jerk)])),
            Relocations = samples.Skip(1).Count(sample => sample.IsTeleported),
        };
    }

    /// <summary>The figures as names and values with units, for display.</summary>
    public IEnumerable<(string Name, string Value)> Rows()
    {
        yield return ("distance driven", FormattableString.Invariant($"{Metres:0} m in {Seconds:0} s"));
        yield return (
            "by the controller",
            FormattableString.Invariant(
                $"{ControllerMetres:0} m, of which {JudgedMetres:0} m outside junctions; mean speed {ControllerMeanSpeed:0.0} m/s"
            )
        );
        yield return ("lane departures", FormattableString.Invariant($"{LaneDepartures}"));
        yield return ("lane changes", FormattableString.Invariant($"{LaneChanges}"));
        yield return ("lateral error", FormattableString.Invariant($"{RmsLateralError:0.000} m RMS, {LargestLateralError:0.00} m max"));
        yield return (
            "collisions",
            FormattableString.Invariant($"{Collisions} outside junctions, {CollisionsInJunctions} inside; ")
                + FormattableString.Invariant(
                    $"built-in driver: {CollisionsOfOwnDriver} outside junctions, {CollisionsOfOwnDriverInJunctions} inside"
                )
        );
        yield return ("jerk", FormattableString.Invariant($"{RmsJerk:0.0} m/s³ RMS"));
        yield return ("repositioned", FormattableString.Invariant($"{Relocations}"));
    }

    private static double RootMeanSquare(double[] values) =>
        values.Length > 0 ? Math.Sqrt(values.Sum(value => value * value) / values.Length) : 0;

    private static double Rounded(double value) => Math.Round(value, Decimals) + 0.0;
}
