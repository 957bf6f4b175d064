using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>A stretch of pavement along one side of a street that no other road crosses.</summary>
/// <param name="Road">The street.</param>
/// <param name="OnRight">Whether it lies on the right of the street's line.</param>
/// <param name="From">Its start, metres along the street.</param>
/// <param name="To">Its end.</param>
internal sealed record Walkway(Road Road, bool OnRight, double From, double To)
{
    /// <summary>Width of a pavement, metres.</summary>
    public const double Width = 3;

    /// <summary>Height of a kerb, metres.</summary>
    public const double KerbHeight = 0.15;

    private const double SampleStep = 2;
    private const double Shortest = 8;

    /// <summary>+1 on the right, -1 on the left.</summary>
    public int Side => OnRight ? 1 : -1;

    public double Length => To - From;

    /// <summary>Offset from the street's line of a point at a distance beyond the kerb, metres.</summary>
    public double OffsetBeyondKerb(double metres) => OnRight ? Road.RightKerb + metres : Road.LeftKerb - metres;

    public Vector3D PlaceBeyondKerb(double distance, double metres) =>
        Road.Curve.OffsetAt(distance, OffsetBeyondKerb(metres)) + (Horizontal.Up * KerbHeight);

    /// <summary>Derivative of that point with respect to the distance along the street's line.</summary>
    public Vector3D TangentBeyondKerb(double distance, double metres) => Road.Curve.OffsetTangentAt(distance, OffsetBeyondKerb(metres));

    /// <summary>Finds the stretches along all streets.</summary>
    public static List<Walkway> Find(RoadPlan plan, StreetIndex index)
    {
        List<Walkway> found = [];
        foreach (Road road in plan.Roads)
        {
            if (road.IsStreet)
            {
                AddSide(found, road, onRight: true, index);
                AddSide(found, road, onRight: false, index);
            }
        }

        return found;
    }

    private static void AddSide(List<Walkway> found, Road road, bool onRight, StreetIndex index)
    {
        double offset = onRight ? road.RightKerb + (Width / 2) : road.LeftKerb - (Width / 2);
        int steps = (int)Math.Ceiling(road.Length / SampleStep);
        double? start = null;
        for (int i = 0; i <= steps; i++)
        {
            double distance = road.Length * i / steps;
            bool isFree = !index.IsOnAnother(road, road.Curve.OffsetAt(distance, offset), Width);
            start = isFree ? start ?? distance : start;
            if (start is { } from && (!isFree || i == steps))
            {
                double to = isFree ? distance : road.Length * (i - 1) / steps;
                if (to - from > Shortest)
                {
                    found.Add(new Walkway(road, onRight, from, to));
                }

                start = null;
            }
        }
    }
}
