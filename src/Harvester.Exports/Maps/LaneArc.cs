namespace Harvester.Exports.Maps;

/// <summary>An arc of a circle, or a straight line, on the ground.</summary>
/// <param name="X">Where it starts, metres east.</param>
/// <param name="Y">Where it starts, metres north.</param>
/// <param name="Heading">Its direction there, radians from east to north.</param>
/// <param name="Curvature">Per metre, positive to the left; 0 is straight.</param>
/// <param name="Length">Metres.</param>
internal readonly record struct LaneArc(double X, double Y, double Heading, double Curvature, double Length)
{
    /// <summary>Arcs with less curvature are straight, per metre: over 100 m they leave their chord by 1 mm.</summary>
    private const double Straight = 1e-6;

    /// <summary>Whether it is a line.</summary>
    public bool IsStraight => Math.Abs(Curvature) < Straight;

    /// <summary>Position and heading at a length from its start.</summary>
    public (double X, double Y, double Heading) At(double length)
    {
        if (IsStraight)
        {
            return (X + (Math.Cos(Heading) * length), Y + (Math.Sin(Heading) * length), Heading);
        }

        double heading = Heading + (Curvature * length);
        return (
            X + ((Math.Sin(heading) - Math.Sin(Heading)) / Curvature),
            Y + ((Math.Cos(Heading) - Math.Cos(heading)) / Curvature),
            heading
        );
    }
}
