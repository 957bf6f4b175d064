using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Simulation.Tests.Events;

/// <summary>A road user at a tick.</summary>
/// <param name="Class">Its class.</param>
/// <param name="Pose">Its pose.</param>
/// <param name="Min">Rear, left, lower corner of its model, metres.</param>
/// <param name="Max">Front, right, upper corner of its model, metres.</param>
/// <param name="Velocity">Metres per second, world.</param>
internal sealed record TrueBody(ObjectClass Class, Pose Pose, Vector3D Min, Vector3D Max, Vector3D Velocity)
{
    /// <summary>Direction in which it faces, radians counter-clockwise from east.</summary>
    public double Bearing { get; } = Math.Atan2(Pose.Axes.Forward.Y, Pose.Axes.Forward.X);

    /// <summary>Horizontal speed, m/s.</summary>
    public double Speed { get; } = Math.Sqrt((Velocity.X * Velocity.X) + (Velocity.Y * Velocity.Y));

    public bool IsPerson => Class is ObjectClass.Pedestrian;

    public bool IsVehicle => Class is not (ObjectClass.Pedestrian or ObjectClass.Other);

    /// <summary>Distance that no point of it exceeds from its origin, metres.</summary>
    public double Reach { get; } = Math.Max(Min.Length, Max.Length) + Math.Abs(Max.X - Min.X);

    /// <summary>Its footprint if its origin were at a place and it faced a direction: four corners, in order around it.</summary>
    public (double X, double Y)[] Polygon(double x, double y, double bearing)
    {
        (double sin, double cos) = Math.SinCos(bearing);
        Vector3D middle = Pose.Axes.ToWorld((Min + Max) * 0.5);

        // The middle of the model's box turns with the body about its origin.
        (double sinTurn, double cosTurn) = Math.SinCos(bearing - Bearing);
        double middleX = x + (middle.X * cosTurn) - (middle.Y * sinTurn);
        double middleY = y + (middle.X * sinTurn) + (middle.Y * cosTurn);
        double length = (Max.Y - Min.Y) / 2;
        double width = (Max.X - Min.X) / 2;
        return [Corner(length, width), Corner(-length, width), Corner(-length, -width), Corner(length, -width)];

        (double X, double Y) Corner(double ahead, double left) =>
            (middleX + (ahead * cos) - (left * sin), middleY + (ahead * sin) + (left * cos));
    }

    /// <summary>Its footprint.</summary>
    public (double X, double Y)[] Polygon() => Polygon(Pose.Position.X, Pose.Position.Y, Bearing);

    /// <summary>Middle of its footprint, metres.</summary>
    public (double X, double Y) Middle() => Between(Polygon(), 0, 2);

    /// <summary>Middle of its front (1) or rear (-1), metres.</summary>
    public (double X, double Y) End(int which) => which > 0 ? Between(Polygon(), 0, 3) : Between(Polygon(), 1, 2);

    private static (double X, double Y) Between((double X, double Y)[] corners, int a, int b) =>
        ((corners[a].X + corners[b].X) / 2, (corners[a].Y + corners[b].Y) / 2);

    /// <summary>Its lowest and greatest height, by its eight corners, metres.</summary>
    public (double Low, double High) Heights()
    {
        double[] heights =
        [
            .. from x in new[] { Min.X, Max.X }
            from y in new[] { Min.Y, Max.Y }
            from z in new[] { Min.Z, Max.Z }
            select Pose.ToWorld(new Vector3D(x, y, z)).Z,
        ];
        return (heights.Min(), heights.Max());
    }
}
