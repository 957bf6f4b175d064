using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>
/// The smooth line through a road's nodes: cubic Hermite pieces whose tangents at the nodes are those of the parabola through three
/// neighbours, so position and direction are continuous. Positions on it are given by the distance from its start, metres.
/// </summary>
internal sealed class StreetCurve
{
    /// <summary>Number of chords per piece for measuring its length; at 10 m between nodes the chord error is below 0.1 mm.</summary>
    private const int ChordsPerPiece = 16;

    private const int ProjectionSteps = 12;

    private readonly CurvePiece[] _pieces;
    private readonly double[] _distances;

    /// <param name="nodes">At least two; neighbours must differ.</param>
    /// <param name="startTangent">Unit direction at the start if another road continues smoothly; otherwise null.</param>
    /// <param name="endTangent">Unit direction at the end; otherwise null.</param>
    public StreetCurve(IReadOnlyList<Vector3D> nodes, Vector3D? startTangent = null, Vector3D? endTangent = null)
    {
        Vector3D[] tangents = Tangents(nodes, startTangent, endTangent);
        _pieces = new CurvePiece[nodes.Count - 1];
        for (int i = 0; i < _pieces.Length; i++)
        {
            _pieces[i] = CurvePiece.Between(nodes[i], nodes[i + 1], tangents[i], tangents[i + 1]);
        }

        _distances = new double[((nodes.Count - 1) * ChordsPerPiece) + 1];
        Vector3D previous = nodes[0];
        for (int i = 1; i < _distances.Length; i++)
        {
            Vector3D point = At(i).Position;
            _distances[i] = _distances[i - 1] + (point - previous).Length;
            previous = point;
        }
    }

    public double Length => _distances[^1];

    public Vector3D PositionAt(double distance) => At(Parameter(distance)).Position;

    /// <summary>Unit vector along the road.</summary>
    public Vector3D TangentAt(double distance) => At(Parameter(distance)).Derivative.Normalized();

    /// <summary>Curvature on the ground, 1/m, positive in a bend to the left.</summary>
    public double CurvatureAt(double distance)
    {
        (_, Vector3D first, Vector3D second) = At(Parameter(distance));
        return Curvature(first, second);
    }

    /// <summary>A point beside the road, on the level of its line.</summary>
    public Vector3D OffsetAt(double distance, double rightOffset) => SectionAt(distance).At(rightOffset);

    /// <summary>The line perpendicular to the road at a distance.</summary>
    public CrossSection SectionAt(double distance)
    {
        (Vector3D position, Vector3D derivative, _) = At(Parameter(distance));
        return new CrossSection(position, Horizontal.RightOf(derivative));
    }

    /// <summary>
    /// Derivative of a point beside the road with respect to the distance along the road's line: longer than 1 on the outside of a bend.
    /// </summary>
    public Vector3D OffsetTangentAt(double distance, double rightOffset)
    {
        int chord = ChordAt(distance);
        (_, Vector3D derivative, Vector3D second) = At(Parameter(distance));
        Vector3D along = derivative / (ChordsPerPiece * (_distances[chord + 1] - _distances[chord]));

        // At an offset r to the right of a line of curvature κ, positive to the left, a step along the line is 1 + κ r times as long.
        double outside = 1 + (Curvature(derivative, second) * rightOffset);
        return new Vector3D(along.X * outside, along.Y * outside, along.Z);
    }

    /// <summary>
    /// The position whose perpendicular on the ground runs through a point, searched from a distance near it; clamped to the ends.
    /// </summary>
    public double Project(Vector3D point, double nearDistance)
    {
        double distance = nearDistance;
        for (int i = 0; i < ProjectionSteps; i++)
        {
            (Vector3D position, Vector3D first, Vector3D second) = At(Parameter(distance));
            Vector3D tangent = first.Normalized();
            Vector3D offset = point - position;
            double along = (offset.X * tangent.X) + (offset.Y * tangent.Y);
            double lateral = (offset.Y * tangent.X) - (offset.X * tangent.Y);
            double horizontal = (tangent.X * tangent.X) + (tangent.Y * tangent.Y);

            // Newton's method: at the lateral offset y the foot moves by 1 / (1 - κ y) of a step along; the bound keeps steps finite near
            // the centre of curvature.
            double slope = Math.Max(0.2, horizontal - (Curvature(first, second) * lateral));
            double next = Math.Clamp(distance + (along / slope), 0, Length);
            if (Math.Abs(next - distance) < 1e-10)
            {
                break;
            }

            distance = next;
        }

        return distance;
    }

    private static Vector3D[] Tangents(IReadOnlyList<Vector3D> nodes, Vector3D? start, Vector3D? end)
    {
        int last = nodes.Count - 1;
        Vector3D[] tangents = new Vector3D[nodes.Count];
        for (int i = 1; i < last; i++)
        {
            Vector3D before = nodes[i] - nodes[i - 1];
            Vector3D after = nodes[i + 1] - nodes[i];
            double lengthBefore = before.Length;
            double lengthAfter = after.Length;

            // The unit chords, each weighted by the other's length over the sum: on a circle exactly the tangent, whatever the spacing.
            tangents[i] = ((before * (lengthAfter / lengthBefore)) + (after * (lengthBefore / lengthAfter))) / (lengthBefore + lengthAfter);
        }

        Vector3D first = (nodes[1] - nodes[0]).Normalized();
        Vector3D final = (nodes[last] - nodes[last - 1]).Normalized();
        tangents[0] =
            start
            ?? (
                last > 1 ? Mirrored(first, tangents[1])
                : end is { } e ? Mirrored(first, e)
                : first
            );
        tangents[last] = end ?? (last > 1 ? Mirrored(final, tangents[last - 1]) : Mirrored(final, tangents[0]));
        return tangents;
    }

    /// <summary>The end tangent that makes the last piece a parabola.</summary>
    // 2c - d, the mirror image of d about the chord c for small angles, where d · c is nearly 1.
    private static Vector3D Mirrored(Vector3D chordDirection, Vector3D inner) => ((chordDirection * 2) - inner.Normalized()).Normalized();

    /// <summary>Curvature on the ground, 1/m, from the first and second derivative.</summary>
    private static double Curvature(Vector3D first, Vector3D second)
    {
        // κ = (p' × p'') / |p'|³ on the ground.
        double speedSquared = (first.X * first.X) + (first.Y * first.Y);
        return ((first.X * second.Y) - (first.Y * second.X)) / (speedSquared * Math.Sqrt(speedSquared));
    }

    private double Parameter(double distance)
    {
        int chord = ChordAt(distance);
        double fraction = (distance - _distances[chord]) / (_distances[chord + 1] - _distances[chord]);
        return chord + Math.Clamp(fraction, 0, 1);
    }

    private int ChordAt(double distance)
    {
        int index = Array.BinarySearch(_distances, distance);
        return Math.Clamp(index >= 0 ? index : ~index - 1, 0, _distances.Length - 2);
    }

    /// <summary>Position and derivatives at a chord number, which may be fractional.</summary>
    private (Vector3D Position, Vector3D Derivative, Vector3D Second) At(double chord)
    {
        int piece = Math.Clamp((int)(chord / ChordsPerPiece), 0, _pieces.Length - 1);
        return _pieces[piece].At((chord / ChordsPerPiece) - piece);
    }
}
