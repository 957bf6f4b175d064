using Harvester.Geometry;
using Harvester.Simulation.Models;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Traffic;

namespace Harvester.Simulation.World;

/// <summary>Where and when the ego begins a scenario.</summary>
internal static class StageStart
{
    /// <summary>How much an angle of a radian counts beside the distance from a lane's line, metres.</summary>
    private const double MetresPerRadian = 3;
    private const double MaxTurn = 1;

    /// <summary>Time between two looks at the lights, and the longest time to look ahead, seconds: two cycles of the lights.</summary>
    private const double LightStep = 0.25;
    private const double LongestWait = 60;

    /// <summary>Lights stay green for so long after the ego has come to them, seconds.</summary>
    private const double GreenAfter = 1;

    /// <summary>
    /// Lanes lead along a way if their middles and ends are at most this far beside it, metres: the town's ways through junctions and those
    /// of the map are other curves between the same ends.
    /// </summary>
    private const double MaxBeside = 4;

    /// <summary>The way is followed so far, metres, as scenarios happen within it.</summary>
    private const double Followed = 120;

    /// <summary>The lane on which the ego begins.</summary>
    /// <exception cref="ArgumentException">No lane leads there in its direction, or the lanes do not lead along its way.</exception>
    public static (LanePath Path, double Distance) Of(LaneGraph lanes, StageSetting setting)
    {
        Vector3D forward = Axes.FromHeading(setting.HeadingDegrees).Forward;
        LanePlace[] near =
        [
            .. new LaneFinder(lanes)
                .Near(setting.Ground)
                .Where(place => Turn(place) < MaxTurn)
                .OrderBy(place => Math.Abs(place.RightOffset) + (MetresPerRadian * Turn(place))),
        ];
        if (near.Length == 0)
        {
            throw new ArgumentException(
                FormattableString.Invariant($"No lane leads that way at {setting.Ground.X:0.0}, {setting.Ground.Y:0.0}.")
            );
        }

        CheckWay(setting.Way, near[0].Path, near[0].Distance);
        return (near[0].Path, near[0].Distance);

        double Turn(LanePlace place) => Math.Abs(Horizontal.Turn(place.Path.Line.TangentAt(place.Distance), forward));
    }

    /// <summary>Checks that who drives along a way comes along it.</summary>
    private static void CheckWay(IReadOnlyList<Vector3D> way, LanePath path, double distance)
    {
        double length = 0;
        for (int i = 1; i < way.Count; i++)
        {
            length += Horizontal.Distance(way[i], way[i - 1]);
        }

        double end = Math.Min(length, Followed);
        double driven = path.Length - distance;
        while (driven < end && path.Next.Count > 0)
        {
            path = Along(way, path.Next);
            double half = driven + (path.Length / 2);
            driven += path.Length;
            if (
                (half < end && DistanceTo(way, path.Line.PositionAt(path.Length / 2)) > MaxBeside)
                || (driven < end && DistanceTo(way, path.Line.PositionAt(path.Length)) > MaxBeside)
            )
            {
                throw new ArgumentException(FormattableString.Invariant($"The lanes lead elsewhere {half:0} m ahead of the ego."));
            }
        }
    }

    /// <summary>Seconds to let pass until the lights on the ego's way are green when it is to come to them.</summary>
    public static double SecondsToGreen(
        StageSetting setting,
        (LanePath Path, double Distance) start,
        LaneControl control,
        double timeSeconds
    )
    {
        if (setting.Green is not { } green)
        {
            return 0;
        }

        (LanePath Lane, double From, double To)[] lights = [.. LightsOnWay(setting, green, start)];
        for (double later = 0; green.From + later < green.To; later += LightStep)
        {
            for (double wait = 0; wait < LongestWait; wait += LightStep)
            {
                if (Array.TrueForAll(lights, light => IsGreen(light.Lane, wait, Math.Min(light.From + later, light.To), light.To)))
                {
                    return wait;
                }
            }
        }

        return 0;

        bool IsGreen(LanePath lane, double wait, double from, double to)
        {
            for (double at = from; at <= to; at += LightStep)
            {
                if (control.LightFor(lane, lane.Next[0].Junction!, timeSeconds + wait + at) is SignalState.Amber or SignalState.Red)
                {
                    return false;
                }
            }

            return true;
        }
    }

    /// <summary>
    /// The lanes on the ego's way that may end at lights, up to where it is when the lights need no longer be green, and when each must be:
    /// so long before and after the ego comes to the lane's end as before and after it comes to the last.
    /// </summary>
    private static IEnumerable<(LanePath Lane, double From, double To)> LightsOnWay(
        StageSetting setting,
        (double From, double To) green,
        (LanePath Path, double Distance) start
    )
    {
        (LanePath path, double distance) = start;
        double length = path.Length - distance;
        while (path.Next.Count > 0 && length < setting.Speed * green.To)
        {
            if (path.Road is not null)
            {
                double arrival = length / setting.Speed;
                double earlier = green.To - GreenAfter - arrival;
                yield return (path, Math.Max(0, green.From - earlier), arrival + GreenAfter);
            }

            path = Along(setting.Way, path.Next);
            length += path.Length;
        }
    }

    /// <summary>Chooses of several lanes the one that leads nearest to the ego's way.</summary>
    public static LanePath Along(IReadOnlyList<Vector3D> way, IReadOnlyList<LanePath> choices) =>
        choices.MinBy(path => DistanceTo(way, path.Line.PositionAt(path.Length)) + DistanceTo(way, path.Line.PositionAt(path.Length / 2)))!;

    private static double DistanceTo(IReadOnlyList<Vector3D> way, Vector3D place)
    {
        double least = double.PositiveInfinity;
        for (int i = 0; i < way.Count; i++)
        {
            least = Math.Min(least, Horizontal.SquaredDistance(way[i], place));
        }

        return Math.Sqrt(least);
    }
}
