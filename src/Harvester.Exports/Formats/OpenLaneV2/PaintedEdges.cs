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

    private readonly (MarkingPaint? Paint, int? Number, Vector3D[] Line)[] _markings;

    /// <summary>Prepares the markings.</summary>
    /// <param name="markings">The markings.</param>
    /// <param name="vehicle">The vehicle's frame.</param>
    public PaintedEdges(IReadOnlyList<LaneLineView> markings, Pose vehicle) =>
        _markings = [
            .. markings.Select(view =>
                (
                    view.Paint,
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
        if (Beside(edge, number) is not { } paints)
        {
            return None;
        }

        int dashed = paints.Count(static paint => paint?.Style == MarkingStyle.Dashed);
        return dashed > paints.Count - dashed ? Dashed : Solid;
    }

    /// <summary>The paint along most of an edge: the most frequent; null if less than half of the edge is painted, or it is
    /// unknown.</summary>
    /// <param name="edge">The edge, vehicle's frame, metres.</param>
    public MarkingPaint? PaintOf(IReadOnlyList<Vector3D> edge) =>
        Beside(edge, number: null)
            ?.GroupBy(static paint => (paint?.Style, paint?.Colour))
            .OrderByDescending(static same => same.Count())
            .ThenBy(static same => same.Key)
            .First()
            .First();

    /// <summary>The paint at the places of an edge that have some; null if they are less than half of all.</summary>
    private List<MarkingPaint?>? Beside(IReadOnlyList<Vector3D> edge, int? number)
    {
        int places = Math.Max(2, (int)Math.Ceiling(VehicleRange.LengthOf(edge) / Step));
        var paints = new List<MarkingPaint?>();
        for (int i = 0; i < places; i++)
        {
            double at = (i + 0.5) / places * (edge.Count - 1);
            if (IsPainted(VehicleRange.Part(edge, at, at)[0], number, out MarkingPaint? paint))
            {
                paints.Add(paint);
            }
        }

        return paints.Count < MinShare * places ? null : paints;
    }

    private bool IsPainted(Vector3D place, int? number, out MarkingPaint? paint)
    {
        (paint, double least) = (null, double.PositiveInfinity);
        bool isPainted = false;
        foreach ((MarkingPaint? of, int? marked, Vector3D[] line) in _markings)
        {
            bool hasNumber = marked is not null && number is not null;
            if (hasNumber && marked != number)
            {
                continue;
            }

            double most = hasNumber ? MaxAsideOfMeasured : MaxAside;
            for (int i = 1; i < line.Length; i++)
            {
                var along = new Vector2D(line[i].X - line[i - 1].X, line[i].Y - line[i - 1].Y);
                var to = new Vector2D(place.X - line[i - 1].X, place.Y - line[i - 1].Y);
                double square = along.Dot(along);
                double raw = square > 0 ? to.Dot(along) / square : 0;
                double t = Math.Clamp(raw, 0, 1);
                double apart = (to - (along * t)).Length;

                // So far aside, a place past the end of a line would still be near it.
                bool isPast = hasNumber && ((i == 1 && raw < 0) || (i == line.Length - 1 && raw > 1));
                if (apart < Math.Min(least, most) && !isPast)
                {
                    (paint, least, isPainted) = (of, apart, true);
                }
            }
        }

        return isPainted;
    }
}
