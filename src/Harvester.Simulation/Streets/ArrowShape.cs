using Harvester.Geometry.Paint;

namespace Harvester.Simulation.Streets;

/// <summary>The shape of a painted arrow, in slices across it.</summary>
internal static class ArrowShape
{
    private const double HalfShaft = 0.1;
    private const double HeadLength = 1.2;
    private const double HalfHead = 0.45;

    /// <summary>How far a head to the side reaches, and its length along the road, metres.</summary>
    private const double SideReach = 0.9;
    private const double SideLength = 0.9;

    /// <summary>Length of the slices of a head, metres: its slanted edges are stairs of this size.</summary>
    private const double Slice = 0.06;

    /// <summary>The slices of an arrow from its tip on.</summary>
    /// <param name="kind">Which arrow.</param>
    /// <param name="length">Its length, metres.</param>
    /// <returns>Where each begins and ends, metres from the tip, and how far it reaches to the driver's left and right.</returns>
    public static IEnumerable<(double From, double To, double Left, double Right)> Of(MarkKind kind, double length)
    {
        double head = kind == MarkKind.ArrowStraight ? HeadLength : SideLength;
        int slices = (int)Math.Round(head / Slice);
        for (int i = 0; i < slices; i++)
        {
            double middle = (i + 0.5) / slices;

            // Straight on, a triangle with its tip in front; to a side, one with its tip in the middle of its length.
            double side = HalfShaft + (SideReach * (1 - (2 * Math.Abs(middle - 0.5))));
            (double left, double right) = kind switch
            {
                MarkKind.ArrowLeft => (side, HalfShaft),
                MarkKind.ArrowRight => (HalfShaft, side),
                _ => (HalfHead * middle, HalfHead * middle),
            };
            yield return (head * i / slices, head * (i + 1) / slices, left, right);
        }

        yield return (head, length, HalfShaft, HalfShaft);
    }
}
