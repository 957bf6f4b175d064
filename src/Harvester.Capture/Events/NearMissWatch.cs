using Harvester.Sessions.Events;

namespace Harvester.Capture.Events;

/// <summary>Finds near misses of the ego: by the time to collision, and by the post-encroachment time of ways that cross.</summary>
internal sealed class NearMissWatch : IEventWatch
{
    private static readonly double CrossingSine = Math.Sin(EventRules.CrossingDegrees * Math.PI / 180);

    /// <inheritdoc/>
    public void Observe(SceneReading reading, EventBook book)
    {
        RoadUser ego = reading.Ego;
        foreach (RoadUser other in reading.Others)
        {
            OpenEvent? open = book.Find(EventKind.NearMiss, ego, other);
            if (book.Find(EventKind.Collision, ego, other) is not null)
            {
                if (open is not null)
                {
                    book.Close(open, EventEnd.Collision, reading.Seconds);
                }

                continue;
            }

            double? time = TimeToCollision(ego, other);
            double? encroachment = PostEncroachment(ego, other);
            if (time is null && encroachment is null)
            {
                continue;
            }

            open ??= book.FindOrBegin(EventKind.NearMiss, reading.Seconds, ego, other);
            open.Hold(reading.Seconds, Math.Min(time ?? double.PositiveInfinity, encroachment ?? double.PositiveInfinity));
            open.Measures =
            [
                new(EventMeasures.TimeToCollision, Least(open, EventMeasures.TimeToCollision, time)),
                new(EventMeasures.PostEncroachment, Least(open, EventMeasures.PostEncroachment, encroachment)),
            ];
        }
    }

    /// <summary>The time to collision, seconds; null if it is above the threshold, or the two hardly move against each other.</summary>
    private static double? TimeToCollision(RoadUser ego, RoadUser other)
    {
        (UserReading a, UserReading b) = (ego.Now, other.Now);
        double reach = ((a.Speed + b.Speed) * EventRules.TimeToCollisionSeconds) + Extent(a) + Extent(b);
        return
            ego.IsNew
            || other.IsNew
            || (a.Ground - b.Ground).Length < EventRules.MinRelativeSpeed
            || (a.Box.Centre - b.Box.Centre).Length > reach
            || !a.Box.IsLevelWith(b.Box)
            ? null
            : a.Motion.TimeToCollision(b.Motion, EventRules.TimeToCollisionSeconds);
    }

    /// <summary>Twice the distance of the footprint's corners: turning about the model's origin moves the centre as well.</summary>
    private static double Extent(UserReading reading) => 2 * reading.Box.Radius;

    /// <summary>
    /// How long ago the one left a place that the other occupies now, seconds; null if it is above the threshold or ways do not cross.
    /// </summary>
    private static double? PostEncroachment(RoadUser ego, RoadUser other)
    {
        if (ego.Now.Box.IsLevelWith(other.Now.Box) && ego.Now.Box.Overlaps(other.Now.Box))
        {
            return null;
        }

        double? left = SinceLeft(ego, other);
        double? entered = SinceLeft(other, ego);
        return left < entered || entered is null ? left : entered;
    }

    /// <summary>How long ago the first was last where the second is now, seconds.</summary>
    private static double? SinceLeft(RoadUser first, RoadUser second)
    {
        UserReading now = second.Now;
        if (now.Speed < EventRules.MinCrossingSpeed)
        {
            return null;
        }

        IReadOnlyList<UserReading> readings = first.Readings;
        double reach = first.Now.Box.Radius + now.Box.Radius;
        for (int i = readings.Count - 2; i >= 0; i--)
        {
            UserReading then = readings[i];
            double since = now.Seconds - then.Seconds;
            if (since > EventRules.PostEncroachmentSeconds)
            {
                break;
            }

            if (
                (then.Box.Centre - now.Box.Centre).Length <= reach
                && Math.Abs(then.Box.Forward.Cross(now.Box.Forward)) >= CrossingSine
                && then.Box.IsLevelWith(now.Box)
                && then.Box.Overlaps(now.Box)
            )
            {
                return since;
            }
        }

        return null;
    }

    private static double? Least(OpenEvent open, string name, double? now)
    {
        double? before = open.Measures.FirstOrDefault(measure => measure.Key == name).Value;
        return before is null || now < before ? now ?? before : before;
    }
}
