namespace Harvester.Simulation.Tests.Events;

/// <summary>How a road user goes on with its present speed and turning rate, in small steps.</summary>
/// <param name="Body">The road user now.</param>
/// <param name="Rate">Its turning rate, radians per second, positive to the left.</param>
internal sealed record TrueCourse(TrueBody Body, double Rate)
{
    private const double Touch = 0.001;
    private const double Step = 0.005;

    /// <summary>Moments looked at within a step in which the two could touch: corners may graze for less than a step.</summary>
    private const int Between = 50;

    private (double X, double Y, double Turn) Start => (Body.Pose.Position.X, Body.Pose.Position.Y, 0);

    /// <summary>Whether two touch within a time, seconds.</summary>
    public bool Touches(TrueCourse other, double horizon)
    {
        // By how much two come nearer in a step at most: their speeds, and how fast their farthest points turn.
        double closing = Step * (Body.Speed + other.Body.Speed + (Math.Abs(Rate) * Body.Reach) + (Math.Abs(other.Rate) * other.Body.Reach));
        (double X, double Y, double Turn) a = Start;
        (double X, double Y, double Turn) b = other.Start;
        for (double time = 0; time <= horizon; time += Step)
        {
            if (Math.Abs(a.X - b.X) + Math.Abs(a.Y - b.Y) < 2 * (Body.Reach + other.Body.Reach))
            {
                double gap = Polygons.Distance(At(a), other.At(b));
                int between = gap <= closing ? (int)Math.Min(Between, (horizon - time) / Step * Between) : 0;
                if (
                    gap <= Touch
                    || Enumerable
                        .Range(1, between)
                        .Select(part => part * Step / Between)
                        .Any(seconds => Polygons.Distance(At(Moved(a, seconds)), other.At(other.Moved(b, seconds))) <= Touch)
                )
                {
                    return true;
                }
            }

            a = Moved(a, Step);
            b = other.Moved(b, Step);
        }

        return false;
    }

    private (double X, double Y)[] At((double X, double Y, double Turn) at) => Body.Polygon(at.X, at.Y, Body.Bearing + at.Turn);

    /// <summary>Straight ahead with the direction in the middle of a step.</summary>
    private (double X, double Y, double Turn) Moved((double X, double Y, double Turn) at, double seconds)
    {
        double way = Math.Atan2(Body.Velocity.Y, Body.Velocity.X) + at.Turn + (Rate * seconds / 2);
        return (at.X + (Body.Speed * seconds * Math.Cos(way)), at.Y + (Body.Speed * seconds * Math.Sin(way)), at.Turn + (Rate * seconds));
    }
}
