using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps.Coded;

namespace Harvester.Geometry.Tests.PixelMaps.Screens;

/// <summary>
/// A world of balls on a chequered ground, with a post that is no object. Balls shade the ground under them. Pictures are cast ray by ray
/// through pixel centres, with noise.
/// </summary>
internal sealed class BallWorld(Camera camera, IReadOnlyList<(Vector3D Centre, double Radius, Vector3D Colour)> balls, Vector3D post)
{
    private const double PostRadius = 0.12;
    private const int NoiseLevels = 3;
    private static readonly Vector3D PostColour = new(90, 90, 95);
    private static readonly Vector3D Sky = new(150, 180, 210);

    /// <summary>A picture of a plan.</summary>
    public byte[] Picture(IPicturePlan plan, int number)
    {
        var random = new Random(number);
        IReadOnlyList<ScreenSheet> sheets = plan.Sheets(number);
        bool[] shown = [.. balls.Select((_, index) => plan.IsShown(number, index))];
        var bytes = new byte[3 * camera.Image.PixelCount];
        for (int pixel = 0; pixel < camera.Image.PixelCount; pixel++)
        {
            Vector3D colour = ColourOf(RayOf(pixel), shown, sheets);
            bytes[3 * pixel] = Noisy(colour.X, random);
            bytes[(3 * pixel) + 1] = Noisy(colour.Y, random);
            bytes[(3 * pixel) + 2] = Noisy(colour.Z, random);
        }

        return bytes;
    }

    /// <summary>Which ball is seen at a pixel if only some are there; -1 for none.</summary>
    public int BallAt(int pixel, Func<int, bool> isThere) => Nearest(RayOf(pixel), isThere).Ball;

    private Ray RayOf(int pixel) => camera.RayThrough((pixel % camera.Image.Width) + 0.5, (pixel / camera.Image.Width) + 0.5);

    private Vector3D ColourOf(Ray ray, bool[] shown, IReadOnlyList<ScreenSheet> sheets)
    {
        (int ball, double distance) = Nearest(ray, index => shown[index]);
        if (sheets.Any(sheet => DistanceTo(sheet, ray) < distance))
        {
            return ScreenSheet.Colour;
        }

        if (ball >= 0)
        {
            // The upper side is brighter.
            Vector3D normal = (ray.Origin + (ray.Direction * distance) - balls[ball].Centre) * (1 / balls[ball].Radius);
            return balls[ball].Colour * (0.7 + (0.3 * normal.Z));
        }

        if (distance < double.PositiveInfinity)
        {
            Vector3D place = ray.Origin + (ray.Direction * distance);
            if (place.Z > 1e-6)
            {
                return PostColour;
            }

            bool isShaded = balls
                .Where(
                    (each, index) =>
                        shown[index] && Math.Sqrt(Math.Pow(place.X - each.Centre.X, 2) + Math.Pow(place.Y - each.Centre.Y, 2)) < each.Radius
                )
                .Any();
            double grey = (((int)Math.Floor(place.X) + (int)Math.Floor(place.Y)) & 1) == 0 ? 95 : 110;
            return new Vector3D(grey, grey, grey) * (isShaded ? 0.4 : 1);
        }

        return Sky;
    }

    /// <summary>The nearest thing: the number of a ball, or -1 for ground, post and sky.</summary>
    private (int Ball, double Distance) Nearest(Ray ray, Func<int, bool> isThere)
    {
        (int nearest, double least) = (-1, ray.Direction.Z < 0 ? -ray.Origin.Z / ray.Direction.Z : double.PositiveInfinity);
        least = Math.Min(least, DistanceToPost(ray));
        for (int index = 0; index < balls.Count; index++)
        {
            Vector3D from = ray.Origin - balls[index].Centre;
            double half = from.Dot(ray.Direction);
            double root = (half * half) - from.Dot(from) + (balls[index].Radius * balls[index].Radius);
            if (isThere(index) && root > 0 && -half - Math.Sqrt(root) is var distance && distance < least)
            {
                (nearest, least) = (index, distance);
            }
        }

        return (nearest, least);
    }

    private double DistanceToPost(Ray ray)
    {
        (double dx, double dy) = (ray.Direction.X, ray.Direction.Y);
        (double x, double y) = (ray.Origin.X - post.X, ray.Origin.Y - post.Y);
        double a = (dx * dx) + (dy * dy);
        double b = (x * dx) + (y * dy);
        double root = (b * b) - (a * ((x * x) + (y * y) - (PostRadius * PostRadius)));
        return root > 0 ? (-b - Math.Sqrt(root)) / a : double.PositiveInfinity;
    }

    private static double DistanceTo(ScreenSheet sheet, Ray ray)
    {
        (Vector3D along, Vector3D across) = (sheet.B - sheet.A, sheet.D - sheet.A);
        Vector3D normal = along.Cross(across);
        double distance = (sheet.A - ray.Origin).Dot(normal) / ray.Direction.Dot(normal);
        Vector3D place = ray.Origin + (ray.Direction * distance) - sheet.A;
        double u = place.Dot(along) / along.Dot(along);
        double v = place.Dot(across) / across.Dot(across);
        return distance > 0 && u is >= 0 and <= 1 && v is >= 0 and <= 1 ? distance : double.PositiveInfinity;
    }

    private static byte Noisy(double value, Random random) =>
        (byte)Math.Clamp(Math.Round(value) + random.Next(-NoiseLevels, NoiseLevels + 1), 0, byte.MaxValue);
}
