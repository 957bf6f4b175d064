using Harvester.Geometry;
using Harvester.Geometry.Lanes;

namespace Harvester.Exports.Formats.OpenLaneV2;

/// <summary>Which edges of lanes are painted, by the markings of a frame's label.</summary>
internal sealed class PaintedEdges
{
    /// <summary>The benchmark's numbers.</summary>
    public const int Solid = 1;
    public const int Dashed = 2;

    /// <summary>Not painted, or not known.</summary>
    public const int None = 0;

    /// <summary>Greatest distance of a marking from an edge, metres: less than half of the narrowest lane.</summary>
    private const double MaxAside = 0.75;

    /// <summary>
    /// The same of measured paint that has the edge's number: the edge is that of the lane widths of the settings, and beside six lanes
    /// that are 1.7 m narrower than those it is this far away.
    /// </summary>
    private const double MaxAsideOfMeasured = 10;

    /// <summary>The part of an edge along which a marking must lie.</summary>
    private const double MinShare = 0.5;

    /// <summary>Distance of the places on an edge at which a marking is looked for, metres.</summary>
    private const double Step = 1;

    private readonly (int Kind, int? Number, Vector3D[] Line)[] _markings;

    /// <summary>Prepares the markings.</summary>
    /// <param name="markings">The markings.</param>
    /// <param name="vehicle">The vehicle's frame.</param>
    public PaintedEdges(IReadOnlyList<LaneLineView> markings, Pose vehicle) =>
        _markings = [
            .. markings.Select(view =>
                (
                    view.Paint?.Style == MarkingStyle.Dashed ? Dashed : Solid,
                    view.SigmaMetres is null ? null : (int?)view.Index,
                    VehicleRange.Points([.. view.Points.Select(point => point.World)], vehicle)
                )
            ),
        ];

    /// <summary>How most of an edge is painted.</summary>
    /// <param name="edge">The edge, vehicle's frame, metres.</param>
    /// <param name="number">The number of its boundary, by which measured paint is found; null if it has none.</param>
    public int KindOf(IReadOnlyList<Vector3D> edge, int? number)
    {
        int places = Math.Max(2, (int)Math.Ceiling(VehicleRange.LengthOf(edge) / Step));
        var counts = new int[3];
        for (int i = 0; i < places; i++)
        {
            double at = (i + 0.5) / places * (edge.Count - 1);
            counts[KindAt(VehicleRange.Part(edge, at, at)[0], number)]++;
        }

        return counts[Solid] + counts[Dashed] < MinShare * places ? None
            : counts[Dashed] > counts[Solid] ? Dashed
            : Solid;
    }

    private int KindAt(Vector3D place, int? number)
    {
        (int kind, double least) = (None, double.PositiveInfinity);
        foreach ((int of, int? marked, Vector3D[] line) in _markings.Where(marking => marking.Number is null || marking.Number == number))
        {
            double most = marked is null ? MaxAside : MaxAsideOfMeasured;
            for (int i = 1; i < line.Length; i++)
            {
                var along = new Vector2D(line[i].X - line[i - 1].X, line[i].Y - line[i - 1].Y);
                var to = new Vector2D(place.X - line[i - 1].X, place.Y - line[i - 1].Y);
                double square = along.Dot(along);
                double raw = square > 0 ? to.Dot(along) / square : 0;
                double t = Math.Clamp(raw, 0, 1);
                double apart = (to - (along * t)).Length;

                // So far aside, a place past the end of a line would still be near it.
                bool isPast = marked is not null && ((i == 1 && raw < 0) || (i == line.Length - 1 && raw > 1));
                (kind, least) = apart < Math.Min(least, most) && !isPast ? (of, apart) : (kind, least);
            }
        }

        return kind;
    }
}
