using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Features;

/// <summary>Draws the edges of cuboids in the world over the picture, as rows of dots: the game draws no lines.</summary>
internal sealed class WindowCanvas(IDisplay display, CameraState seen)
{
    private const double DotFraction = 0.003;
    private const int DotsOfAnEdge = 24;

    // Positions are drawn in fractions of the window; any size of image will do.
    private static readonly ImageSize Size = new(1000, 1000);

    private readonly Camera _camera = new(
        seen.Pose,
        new CameraIntrinsics(seen.VerticalFovDegrees, Size, seen.WindowAspect, seen.NearClip, Lens.Ideal)
    );

    /// <summary>Draws the twelve edges of a cuboid.</summary>
    public void Edges(Cuboid cuboid, Colour colour)
    {
        foreach ((Vector3D start, Vector3D end) in cuboid.EdgesInWorld)
        {
            for (int dot = 0; dot <= DotsOfAnEdge; dot++)
            {
                Projection place = _camera.Project(start + ((end - start) * ((double)dot / DotsOfAnEdge)));
                if (place.Outcome == ProjectionOutcome.InImage)
                {
                    Dot(place.U / Size.Width, place.V / Size.Height, colour);
                }
            }
        }
    }

    /// <summary>Marks the middle of the window.</summary>
    public void Cross(Colour colour) => Dot(0.5, 0.5, colour);

    private void Dot(double x, double y, Colour colour) =>
        display.Rectangle(new Box2D(x - (DotFraction / 2), y - (DotFraction / 2), x + (DotFraction / 2), y + (DotFraction / 2)), colour);
}
