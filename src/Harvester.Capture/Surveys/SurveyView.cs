using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Paint;
using Harvester.Sessions.Rigs;

namespace Harvester.Capture.Surveys;

/// <summary>The camera of a survey of paint: high above the vehicle, looking straight down, with the longer side along the road.</summary>
public sealed record SurveyView
{
    /// <summary>Rows of the pictures: whole two-way roads of four lanes.</summary>
    private const int Rows = 900;

    /// <summary>Widest picture: the ends of a wider one are too far away to be measured.</summary>
    private const double MaxAspect = 16.0 / 9;

    /// <summary>Metres of ground in a pixel unless the user says otherwise: three pixels in the narrowest paint.</summary>
    public const double UsualMetresPerPixel = 0.035;

    /// <summary>
    /// Vertical field of view, degrees: the usual one of the game, with which the pixels in the corners of the picture are little larger
    /// than those in its middle.
    /// </summary>
    public const double VerticalFovDegrees = 50;

    /// <summary>Creates a view.</summary>
    /// <param name="image">Size of the pictures, pixels.</param>
    /// <param name="lens">The lens of the game's camera.</param>
    /// <param name="metresPerPixel">Metres of ground in a pixel in the middle of the picture; greater than 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">A picture shows less than 4 m.</exception>
    public SurveyView(ImageSize image, Lens lens, double metresPerPixel)
    {
        Footprint = new SurveyFootprint(image.Width * metresPerPixel, image.Height * metresPerPixel);

        // Half of the picture's height on the ground is h tan(fov / 2).
        HeightMetres = image.Height * metresPerPixel / 2 / Math.Tan(Angles.ToRadians(VerticalFovDegrees) / 2);
        Camera = new RigCamera(
            "above",
            new Pose(new Vector3D(0, 0, HeightMetres), Axes.FromVectors(new(0, 1, 0), new(0, 0, -1), new(-1, 0, 0))),
            VerticalFovDegrees,
            image,
            lens
        );
    }

    /// <summary>Size of the pictures in a window of a shape, pixels.</summary>
    /// <param name="windowAspect">Width divided by height of the window; at least 1 of it is used.</param>
    public static ImageSize ImageFor(double windowAspect) =>
        new((int)Math.Round(Rows * Math.Min(Math.Max(1, windowAspect), MaxAspect)), Rows);

    /// <summary>The ground that a picture shows.</summary>
    public SurveyFootprint Footprint { get; }

    /// <summary>Height of the camera above the origin of the vehicle, metres.</summary>
    public double HeightMetres { get; }

    /// <summary>The camera on the vehicle; its mount is relative to the vehicle's origin.</summary>
    public RigCamera Camera { get; }
}
