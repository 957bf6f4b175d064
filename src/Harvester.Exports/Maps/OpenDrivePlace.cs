using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Exports.Maps;

/// <summary>A place beside a road in OpenDRIVE's terms.</summary>
/// <param name="S">Metres along the road's line, within it.</param>
/// <param name="T">Metres to the left of the line.</param>
/// <param name="Heading">The line's direction there, radians counter-clockwise from east.</param>
/// <param name="Z">Height of the line there, metres.</param>
/// <param name="Parameter">The parameter of the line's curve there.</param>
/// <param name="Beyond">How far the place lies before the line's start or past its end, metres; 0 beside it.</param>
internal readonly record struct OpenDrivePlace(double S, double T, double Heading, double Z, double Parameter, double Beyond)
{
    /// <summary>The line is looked at in pieces of about this length, metres.</summary>
    private const double Step = 1;

    /// <summary>A line is not looked at in more pieces.</summary>
    private const int MaxSteps = 2000;

    private const int NewtonSteps = 8;

    /// <summary>Where the line of a road is nearest to a place.</summary>
    public static OpenDrivePlace Of(HermiteCurve line, double length, Vector3D place)
    {
        var ground = new Vector2D(place.X, place.Y);
        int steps = (int)Math.Clamp(length / Step, 2, MaxSteps);
        double parameter = Enumerable.Range(0, steps + 1).Select(i => (double)i / steps).MinBy(t => (ground - GroundAt(line, t)).Length);
        for (int i = 0; i < NewtonSteps; i++)
        {
            // Newton's method for (place - p) · p' = 0, where the place is beside p. Without the curve's bend, the derivative is -|p'|².
            Vector2D velocity = line.VelocityAt(parameter);
            double square = velocity.Dot(velocity);
            parameter =
                square > 0 ? Math.Clamp(parameter + ((ground - GroundAt(line, parameter)).Dot(velocity) / square), 0, 1) : parameter;
        }

        Vector3D nearest = line.PointAt(parameter);
        Vector2D direction = line.VelocityAt(parameter);
        double heading = Math.Atan2(direction.Y, direction.X);
        var along = new Vector2D(Math.Cos(heading), Math.Sin(heading));
        Vector2D apart = ground - new Vector2D(nearest.X, nearest.Y);
        double s = parameter > 0 ? Math.Min(length, line.Between(0, parameter).Length) : 0;
        return new OpenDrivePlace(s, along.Cross(apart), heading, nearest.Z, parameter, Math.Abs(along.Dot(apart)));
    }

    private static Vector2D GroundAt(HermiteCurve line, double parameter)
    {
        Vector3D point = line.PointAt(parameter);
        return new Vector2D(point.X, point.Y);
    }
}
