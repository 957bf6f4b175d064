using Harvester.Geometry;

namespace Harvester.Capture.Events;

/// <summary>The footprint of a body: a rectangle on the ground, and the heights that the body has.</summary>
/// <param name="Centre">Middle of the model's box, metres, world.</param>
/// <param name="Forward">Horizontal unit direction of its length.</param>
/// <param name="HalfLength">Half the length of the model's box, metres.</param>
/// <param name="HalfWidth">Half the width of the model's box, metres.</param>
/// <param name="Bottom">Lowest height of the box, metres, world.</param>
/// <param name="Top">Greatest height of the box, metres, world.</param>
internal readonly record struct BodyBox(Vector2D Centre, Vector2D Forward, double HalfLength, double HalfWidth, double Bottom, double Top)
{
    private const int CornerCount = 4;

    /// <summary>Distance of the corners from the centre, metres.</summary>
    public double Radius => Math.Sqrt((HalfLength * HalfLength) + (HalfWidth * HalfWidth));

    /// <summary>Horizontal unit direction to the right.</summary>
    public Vector2D Right => new(Forward.Y, -Forward.X);

    /// <summary>The footprint of a model's box.</summary>
    /// <param name="pose">Pose of the model.</param>
    /// <param name="min">Rear, left, lower corner, model frame, metres.</param>
    /// <param name="max">Front, right, upper corner, model frame, metres.</param>
    public static BodyBox Of(Pose pose, Vector3D min, Vector3D max)
    {
        Vector3D centre = pose.ToWorld((min + max) * 0.5);
        Vector3D half = (max - min) * 0.5;
        Axes axes = pose.Axes;

        // A body that stands on its nose has no heading by its forward axis; its right axis is horizontal then.
        Vector2D forward = new(axes.Forward.X, axes.Forward.Y);
        forward = forward.Length > 0 ? forward * (1 / forward.Length) : new Vector2D(-axes.Right.Y, axes.Right.X);

        // Half the height of an oriented box: the sum of its half extents times the vertical components of its axes.
        double height = (Math.Abs(axes.Right.Z) * half.X) + (Math.Abs(axes.Forward.Z) * half.Y) + (Math.Abs(axes.Up.Z) * half.Z);
        return new BodyBox(new Vector2D(centre.X, centre.Y), forward, half.Y, half.X, centre.Z - height, centre.Z + height);
    }

    /// <summary>A corner, 0 to 3 counter-clockwise from the front right one, metres, world.</summary>
    public Vector2D Corner(int number)
    {
        double along = number is 0 or 1 ? HalfLength : -HalfLength;
        double across = number is 0 or 3 ? HalfWidth : -HalfWidth;
        return Centre + (Forward * along) + (Right * across);
    }

    /// <summary>A place from the centre: to the right and forward, metres.</summary>
    public Vector2D ToLocal(Vector2D place)
    {
        Vector2D offset = place - Centre;
        return new Vector2D(offset.Dot(Right), offset.Dot(Forward));
    }

    /// <summary>Whether both have a height in common, so that neither passes above the other.</summary>
    public bool IsLevelWith(BodyBox other) => Bottom <= other.Top && other.Bottom <= Top;

    /// <summary>Horizontal distance between two rectangles, metres; 0 if they overlap.</summary>
    public double Gap(BodyBox other)
    {
        if (Overlaps(other))
        {
            return 0;
        }

        // The nearest points of two convex polygons that are apart include a corner of one of them.
        double least = double.PositiveInfinity;
        for (int corner = 0; corner < CornerCount; corner++)
        {
            least = Math.Min(least, Math.Min(DistanceTo(other.Corner(corner)), other.DistanceTo(Corner(corner))));
        }

        return least;
    }

    /// <summary>Whether two rectangles overlap: no direction of a side of either separates them.</summary>
    public bool Overlaps(BodyBox other)
    {
        Vector2D offset = other.Centre - Centre;
        double reach = Radius + other.Radius;
        return offset.Dot(offset) <= reach * reach
            && !IsParted(other, offset, Forward)
            && !IsParted(other, offset, Right)
            && !IsParted(other, offset, other.Forward)
            && !IsParted(other, offset, other.Right);
    }

    /// <summary>Middle of what two rectangles have in common; the middle between their nearest points if they do not overlap.</summary>
    public Vector2D Common(BodyBox other)
    {
        // The other rectangle, cut off at each side of this one (Sutherland and Hodgman 1974).
        List<Vector2D> polygon = [.. Enumerable.Range(0, CornerCount).Select(other.Corner)];
        for (int side = 0; side < CornerCount && polygon.Count > 0; side++)
        {
            polygon = CutAt(polygon, side);
        }

        return polygon.Count > 0 ? polygon.Aggregate((sum, point) => sum + point) * (1.0 / polygon.Count) : Nearest(other);
    }

    /// <summary>The point of the rectangle that is nearest to a place.</summary>
    public Vector2D NearestTo(Vector2D place)
    {
        Vector2D local = ToLocal(place);
        return Centre + (Right * Limited(local.X, HalfWidth)) + (Forward * Limited(local.Y, HalfLength));
    }

    private static double Limited(double value, double limit) => Math.Max(-limit, Math.Min(limit, value));

    private double DistanceTo(Vector2D place) => (place - NearestTo(place)).Length;

    private Vector2D Nearest(BodyBox other)
    {
        (Vector2D Mine, Vector2D Theirs) best = (Centre, other.Centre);
        for (int corner = 0; corner < CornerCount; corner++)
        {
            Vector2D theirs = other.Corner(corner);
            Vector2D mine = Corner(corner);
            foreach ((Vector2D Mine, Vector2D Theirs) pair in new[] { (NearestTo(theirs), theirs), (mine, other.NearestTo(mine)) })
            {
                best = (pair.Mine - pair.Theirs).Length < (best.Mine - best.Theirs).Length ? pair : best;
            }
        }

        return (best.Mine + best.Theirs) * 0.5;
    }

    private List<Vector2D> CutAt(List<Vector2D> polygon, int side)
    {
        // The outward direction of the side, and how far outside a place is.
        Vector2D outward =
            side == 0 ? Forward
            : side == 1 ? Right
            : side == 2 ? Forward * -1
            : Right * -1;
        double limit = side % 2 == 0 ? HalfLength : HalfWidth;
        var kept = new List<Vector2D>();
        for (int i = 0; i < polygon.Count; i++)
        {
            (Vector2D from, Vector2D to) = (polygon[i], polygon[(i + 1) % polygon.Count]);
            double before = (from - Centre).Dot(outward) - limit;
            double after = (to - Centre).Dot(outward) - limit;
            if (before <= 0)
            {
                kept.Add(from);
            }

            if (before < 0 != after < 0 && before != after)
            {
                kept.Add(from + ((to - from) * (before / (before - after))));
            }
        }

        return kept;
    }

    private bool IsParted(BodyBox other, Vector2D offset, Vector2D axis) => Math.Abs(offset.Dot(axis)) > Reach(axis) + other.Reach(axis);

    /// <summary>Half the length of the rectangle's projection on an axis, metres.</summary>
    private double Reach(Vector2D axis) => (Math.Abs(Forward.Dot(axis)) * HalfLength) + (Math.Abs(Right.Dot(axis)) * HalfWidth);
}
