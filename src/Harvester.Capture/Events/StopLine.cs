using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Paint;

namespace Harvester.Capture.Events;

/// <summary>The end of the lanes of a road before a junction, where a light or a stop sign holds back the traffic.</summary>
/// <param name="Id">Name of the leftmost lane.</param>
/// <param name="Left">Its left end as the traffic sees it, metres, world.</param>
/// <param name="Right">Its right end.</param>
/// <param name="Direction">Unit vector of the traffic's direction on the ground.</param>
internal sealed record StopLine(string Id, Vector3D Left, Vector3D Right, Vector2D Direction)
{
    /// <summary>
    /// A painted line farther from the ends of the lanes is that of another road, metres: crossings and corners are narrower.
    /// </summary>
    public const double MaxMove = 12;

    /// <summary>A vehicle farther beside the line is on another road, as a multiple of the line's length from its middle.</summary>
    private const double MaxAside = 1;

    /// <summary>Whether a stop sign stands there.</summary>
    public bool HasStopSign { get; set; }

    /// <summary>Whether a light shows red there, and none another colour.</summary>
    public bool IsRed { get; set; }

    /// <summary>The game's time at which the light became red, seconds; null if it is not red, or was when it was first seen.</summary>
    public double? RedSince { get; set; }

    /// <summary>Its middle, metres, world.</summary>
    public Vector3D Middle => (Left + Right) * 0.5;

    /// <summary>The end of the lanes that a light or sign governs.</summary>
    public static StopLine AtEndOf(IReadOnlyList<MapLane> lanes)
    {
        (MapLane first, MapLane last) = (lanes[0], lanes[lanes.Count - 1]);
        return new StopLine(first.Id, first.Left[first.Left.Count - 1], last.Right[last.Right.Count - 1], first.EndDirection);
    }

    /// <summary>
    /// The line, moved along the direction of travel to the nearest painted line across its lanes; unchanged without such a line.
    /// </summary>
    /// <param name="marks">Painted stop lines.</param>
    public StopLine MovedTo(IEnumerable<PaintedMark> marks)
    {
        double? least = null;
        foreach (PaintedMark mark in marks)
        {
            Vector3D middle = mark.Corners.Aggregate(Vector3D.Zero, static (sum, corner) => sum + corner) * (1.0 / mark.Corners.Count);
            var place = new Vector2D(middle.X, middle.Y);
            double past = Past(place);
            if (
                Spans(place)
                && Math.Abs(middle.Z - Left.Z) <= EventRules.LevelMetres
                && (least is null || Math.Abs(past) < Math.Abs(least.Value))
            )
            {
                least = past;
            }
        }

        Vector3D move = new Vector3D(Direction.X, Direction.Y, 0) * (least ?? 0);
        return this with { Left = Left + move, Right = Right + move };
    }

    /// <summary>How far a place lies past the line, metres; negative before it.</summary>
    public double Past(Vector2D place)
    {
        Vector2D line = Line;
        return line.Cross(place - new Vector2D(Left.X, Left.Y)) / line.Length;
    }

    /// <summary>Whether a place lies between the ends of the line, if both are moved along the traffic's direction.</summary>
    public bool Spans(Vector2D place) => Aside(place) <= 0.5;

    /// <summary>Whether a body may belong to the line's traffic: it faces along it, on its level, not far beside it.</summary>
    public bool Concerns(BodyBox box) =>
        box.Forward.Dot(Direction) >= Math.Cos(EventRules.LaneDegrees * Math.PI / 180)
        && Math.Abs(box.Bottom - Left.Z) <= EventRules.LevelMetres
        && Aside(box.Centre) <= MaxAside;

    private Vector2D Line => new(Right.X - Left.X, Right.Y - Left.Y);

    /// <summary>Distance from the middle of the line along it, as a multiple of its length.</summary>
    private double Aside(Vector2D place)
    {
        Vector2D line = Line;
        return Math.Abs(((place - new Vector2D(Left.X, Left.Y)).Dot(line) / line.Dot(line)) - 0.5);
    }
}
