using Harvester.Geometry;
using Harvester.Sessions.Events;

namespace Harvester.Capture.Events;

/// <summary>Finds vehicles that drive past a stop line at a red light, or at a stop sign without having stopped.</summary>
internal sealed class StopLineWatch : IEventWatch
{
    private readonly Dictionary<OpenEvent, StopLine> _lines = [];
    private Dictionary<(RoadUser User, string Line), LineApproach> _approaches = [];

    /// <inheritdoc/>
    public void Observe(SceneReading reading, EventBook book)
    {
        HoldOpen(reading, book);
        var approaches = new Dictionary<(RoadUser User, string Line), LineApproach>();
        foreach (RoadUser user in reading.Roads is null ? [] : reading.Driven)
        {
            BodyBox box = user.Now.Box;
            foreach (StopLine line in reading.Roads!.Lines.Where(line => line.Concerns(box)))
            {
                double front = line.Past(FrontOf(box));
                double middle = line.Past(box.Centre);
                _approaches.TryGetValue((user, line.Id), out LineApproach? approach);
                if (middle < 0 && front >= -EventRules.StopMetres)
                {
                    approach ??= new LineApproach(front);
                    approach.Slowest = Math.Min(approach.Slowest, user.Now.Speed);
                    approach.IsOnRed = front < 0 ? null : approach.IsOnRed ?? line.IsRed;
                    approaches[(user, line.Id)] = approach;
                }
                else if (middle >= 0 && approach is not null && line.Spans(box.Centre))
                {
                    Passed(reading, book, user, line, approach);
                }
            }
        }

        _approaches = approaches;
    }

    private static Vector2D FrontOf(BodyBox box) => box.Centre + (box.Forward * box.HalfLength);

    private static Vector2D RearOf(BodyBox box) => box.Centre - (box.Forward * box.HalfLength);

    /// <summary>The event lasts until the rear has passed the line.</summary>
    private void HoldOpen(SceneReading reading, EventBook book)
    {
        foreach (OpenEvent open in _lines.Keys.ToList())
        {
            StopLine line = _lines[open];
            if (!book.Open.Contains(open) || line.Past(RearOf(open.Users[0].Now.Box)) >= 0)
            {
                _lines.Remove(open);
            }
            else
            {
                open.Hold(reading.Seconds, 0);
            }
        }
    }

    /// <summary>The middle of a vehicle has passed a line.</summary>
    private void Passed(SceneReading reading, EventBook book, RoadUser user, StopLine line, LineApproach approach)
    {
        double speed = user.Now.Speed;
        double slowest = Math.Min(approach.Slowest, speed);

        // A front that was first seen past the line passed it at an unknown light; one that jumped over it, at the present one.
        if (line.IsRed && approach.First < 0 && (approach.IsOnRed ?? true))
        {
            double? red = line.RedSince is { } since ? reading.Seconds - since : null;
            Begin(EventKind.RedLightRun, new(EventMeasures.Speed, speed), new(EventMeasures.Red, red));
        }

        if (line.HasStopSign && approach.First <= -EventRules.SeenMetres && slowest >= EventRules.StandingSpeed)
        {
            Begin(EventKind.StopSignRun, new(EventMeasures.Speed, speed), new(EventMeasures.MinSpeed, slowest));
        }

        void Begin(EventKind kind, params KeyValuePair<string, double?>[] measures)
        {
            OpenEvent open = book.FindOrBegin(kind, reading.Seconds, user);
            if (open.Hold(reading.Seconds, 0))
            {
                open.Measures = measures;
            }

            _lines[open] = line;
        }
    }
}
