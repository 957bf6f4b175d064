namespace Harvester.Runs.Tests.Scenarios;

/// <summary>
/// The recorded poses of a scenario, beside the line that the ego drove, prolonged straight at both ends. It knows nothing of lanes.
/// </summary>
internal sealed class SceneTrace
{
    private const double Prolonged = 150;
    private const double Step = 0.4;
    private readonly List<(double X, double Y, double At)> _line = [];
    private readonly IReadOnlyList<SeenMoment> _moments;

    public SceneTrace(IReadOnlyList<SeenMoment> moments)
    {
        _moments = moments;
        SeenBody first = moments[0].Ego;
        SeenBody last = moments[^1].Ego;
        Add(first.X - (first.ForwardX * Prolonged), first.Y - (first.ForwardY * Prolonged));
        foreach (SeenMoment moment in moments)
        {
            if (Math.Sqrt(Squared(moment.Ego.X - _line[^1].X, moment.Ego.Y - _line[^1].Y)) > Step)
            {
                Add(moment.Ego.X, moment.Ego.Y);
            }
        }

        Add(last.X + (last.ForwardX * Prolonged), last.Y + (last.ForwardY * Prolonged));
    }

    public IReadOnlyList<SeenMoment> Moments => _moments;

    /// <summary>An actor in all moments in which it was there.</summary>
    public SeenPlace[] Of(string actor) =>
        [.. _moments.Where(moment => moment.Actors.ContainsKey(actor)).Select(moment => Place(moment, moment.Actors[actor]))];

    private SeenPlace Place(SeenMoment moment, SeenBody body)
    {
        (double egoAt, _, _, _) = Locate(moment.Ego.X, moment.Ego.Y);
        (double at, double right, double x, double y) = Locate(body.X, body.Y);
        double along = (body.VelocityX * x) + (body.VelocityY * y);
        double turn = Math.Atan2((x * body.ForwardY) - (y * body.ForwardX), (x * body.ForwardX) + (y * body.ForwardY)) * 180 / Math.PI;

        // Half of the length along the line of a body that is turned: |cos| L + |sin| W.
        double cosine = Math.Abs(Math.Cos(turn * Math.PI / 180));
        double sine = Math.Abs(Math.Sin(turn * Math.PI / 180));
        bool looksAhead = Math.Abs(turn) < 90;
        double toFront = (cosine * (looksAhead ? body.Front : body.Rear)) + (sine * body.HalfWidth);
        double toRear = (cosine * (looksAhead ? body.Rear : body.Front)) + (sine * body.HalfWidth);
        double gap = at > egoAt ? at - toRear - egoAt - moment.Ego.Front : egoAt - moment.Ego.Rear - at - toFront;
        return new SeenPlace(moment.Seconds, at - egoAt, right, body.Speed, along, turn, gap, moment.Ego.Speed);
    }

    private void Add(double x, double y) =>
        _line.Add((x, y, _line.Count == 0 ? 0 : _line[^1].At + Math.Sqrt(Squared(x - _line[^1].X, y - _line[^1].Y))));

    private (double At, double Right, double X, double Y) Locate(double x, double y)
    {
        double least = double.PositiveInfinity;
        (double At, double Right, double X, double Y) best = default;
        for (int i = 1; i < _line.Count; i++)
        {
            (double ax, double ay, double at) = _line[i - 1];
            double length = _line[i].At - at;
            double dx = (_line[i].X - ax) / length;
            double dy = (_line[i].Y - ay) / length;
            double along = Math.Clamp(((x - ax) * dx) + ((y - ay) * dy), 0, length);
            double squared = Squared(x - ax - (dx * along), y - ay - (dy * along));
            if (squared < least)
            {
                least = squared;
                best = (at + along, ((x - ax) * dy) - ((y - ay) * dx), dx, dy);
            }
        }

        return best;
    }

    private static double Squared(double x, double y) => (x * x) + (y * y);
}
