using Harvester.Runs.Evaluation.Figures;

namespace Harvester.Runs.Evaluation.Scores;

/// <summary>
/// The driving score of an episode, as in CARLA's leaderboards 1.0 and 2.0: route completion times a factor for each infraction. It counts
/// the whole drive, whatever the driver.
/// </summary>
public sealed record EpisodeScore
{
    /// <summary>Factor for a collision with a pedestrian.</summary>
    public const double PedestrianPenalty = 0.5;

    /// <summary>Factor for a collision with a vehicle, also a parked one.</summary>
    public const double VehiclePenalty = 0.6;

    /// <summary>Factor for running a red light.</summary>
    public const double RedLightPenalty = 0.7;

    /// <summary>Factor for running a stop sign.</summary>
    public const double StopSignPenalty = 0.8;

    /// <summary>
    /// Time that a car has stood before the game repositions it because it is stuck, not at the end of the roads, seconds.
    /// </summary>
    private const double StuckSeconds = 10;
    private const double StandingSpeed = 0.1;
    private const int Decimals = 4;

    /// <summary>Distance to drive, metres, greater than 0.</summary>
    public required double WantedMetres { get; init; }

    /// <summary>Distance driven, metres, without repositioning.</summary>
    public required double DrivenMetres { get; init; }

    /// <summary>Part of it with a part of the car outside the lanes of its direction, metres.</summary>
    public required double OutsideMetres { get; init; }

    /// <summary>All collisions.</summary>
    public required CollisionCounts Collisions { get; init; }

    /// <summary>Those while the built-in driver drove.</summary>
    public required CollisionCounts CollisionsOfBuiltInDriver { get; init; }

    /// <summary>Red lights that the controller ran.</summary>
    public required int RedLights { get; init; }

    /// <summary>Stop signs that the controller ran.</summary>
    public required int StopSigns { get; init; }

    /// <summary>Times that the game repositioned the car after it had stood for long.</summary>
    public required int Stuck { get; init; }

    /// <summary>Share of the wanted distance that was driven, 0 to 1.</summary>
    public double RouteCompletionFraction => Rounded(Math.Min(1, DrivenMetres / WantedMetres));

    /// <summary>Product of the factors of all infractions and of the share of the distance inside the lanes, 0 to 1.</summary>
    public double PenaltyFraction => Rounded(Penalty);

    /// <summary>Route completion times the penalty, 0 to 100.</summary>
    public double DrivingScore => Rounded(100 * Math.Min(1, DrivenMetres / WantedMetres) * Penalty);

    private double Penalty =>
        Math.Pow(VehiclePenalty, Collisions.Vehicles + Collisions.Parked)
        * Math.Pow(PedestrianPenalty, Collisions.Pedestrians)
        * Math.Pow(RedLightPenalty, RedLights)
        * Math.Pow(StopSignPenalty, StopSigns)
        * (1 - (DrivenMetres > 0 ? Math.Min(1, OutsideMetres / DrivenMetres) : 0));

    /// <summary>Evaluates the samples of an episode.</summary>
    /// <param name="samples">The samples, at equal intervals.</param>
    /// <param name="wantedMetres">Distance to drive, metres, greater than 0.</param>
    public static EpisodeScore Of(IReadOnlyList<DriveSample> samples, double wantedMetres)
    {
        ArgumentNullException.ThrowIfNull(samples);
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(wantedMetres);
        double driven = 0;
        double outside = 0;
        double standing = 0;
        int stuck = 0;
        for (int i = 1; i < samples.Count; i++)
        {
            if (samples[i].IsTeleported)
            {
                stuck += standing >= StuckSeconds ? 1 : 0;
                standing = 0;
                continue;
            }

            double way = (samples[i].Position - samples[i - 1].Position).Length;
            driven += way;
            outside += samples[i].Lane is { IsBeyondLanes: true } ? way : 0;
            standing = samples[i].Speed < StandingSpeed ? standing + samples[i].TimeSeconds - samples[i - 1].TimeSeconds : 0;
        }

        DriveCounters last = samples.Count > 0 ? samples[^1].Counters : default;
        return new EpisodeScore
        {
            WantedMetres = wantedMetres,
            DrivenMetres = Rounded(driven),
            OutsideMetres = Rounded(outside),
            Collisions = new CollisionCounts(last.Vehicles, last.Parked, last.Pedestrians),
            CollisionsOfBuiltInDriver = new CollisionCounts(
                OfBuiltInDriver(samples, static counters => counters.Vehicles),
                OfBuiltInDriver(samples, static counters => counters.Parked),
                OfBuiltInDriver(samples, static counters => counters.Pedestrians)
            ),
            RedLights = last.RedLights,
            StopSigns = last.StopSigns,
            Stuck = stuck,
        };
    }

    private static int OfBuiltInDriver(IReadOnlyList<DriveSample> samples, Func<DriveCounters, int> count) =>
        Enumerable
            .Range(0, samples.Count)
            .Where(i => !samples[i].IsByController)
            .Sum(i => count(samples[i].Counters) - (i > 0 ? count(samples[i - 1].Counters) : 0));

    private static double Rounded(double value) => Math.Round(value, Decimals) + 0.0;
}
