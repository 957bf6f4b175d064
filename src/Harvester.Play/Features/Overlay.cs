using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Features;

/// <summary>Draws over the game the boxes of the objects that would be labelled now, the faces of signs, and the lane lines.</summary>
public sealed class Overlay : IFeature
{
    private const double LineFraction = 0.0015;

    /// <summary>Distance of the dots of a lane line, as a fraction of the window.</summary>
    private const double DotFraction = 0.02;

    /// <summary>Distance up to which lane lines are drawn, metres along the road, as in labels.</summary>
    private const double LaneReach = 70;

    // The boxes are drawn in fractions of the window; any size of image will do.
    private static readonly ImageSize Canvas = new(1000, 1000);
    private static readonly Colour Vehicles = new(80, 220, 120);
    private static readonly Colour People = new(255, 170, 60);
    private static readonly Colour Signs = new(90, 170, 255);
    private static readonly Colour Lanes = new(255, 255, 120);
    private readonly Harvest _harvest;
    private readonly GamePorts _game;
    private readonly PlayerMessages _messages;
    private readonly OverlayReader _sight;
    private readonly IDisplay _display;
    private RoadMatch? _previous;

    /// <summary>Creates an overlay that is off.</summary>
    /// <param name="harvest">Its options and faces select what is drawn.</param>
    /// <param name="game">The known roads.</param>
    /// <param name="messages">Reports why it cannot be switched on.</param>
    /// <param name="sight">Reads the visible entities; if the camera is mounted, lanes are those of its vehicle.</param>
    /// <param name="display">Draws.</param>
    public Overlay(Harvest harvest, GamePorts game, PlayerMessages messages, OverlayReader sight, IDisplay display)
    {
        _harvest = harvest;
        _game = game;
        _messages = messages;
        _sight = sight;
        _display = display;
    }

    /// <inheritdoc/>
    public string Name => "The overlay";

    /// <summary>Whether nothing may be drawn now.</summary>
    public Func<bool> IsPictureNear { get; init; } = static () => false;

    /// <inheritdoc/>
    public bool IsOn { get; private set; }

    /// <summary>Switches the overlay on or off.</summary>
    public void Toggle()
    {
        string? problem = _harvest.Problem();
        IsOn = !IsOn && problem is null;
        if (problem is not null)
        {
            _messages.Tell(problem);
        }
    }

    /// <inheritdoc/>
    public void Tick()
    {
        if (!IsOn || IsPictureNear())
        {
            return;
        }

        HarvestOptions options = _harvest.Options;
        CameraState state = _sight.ReadCamera();
        var camera = new Camera(
            state.Pose,
            new CameraIntrinsics(state.VerticalFovDegrees, Canvas, state.WindowAspect, state.NearClip, options.Lens)
        );
        foreach (SeenEntity entity in _sight.Around(state.Pose, options.RangeMetres))
        {
            if (options.Classes?.Contains(entity.Model.Class) ?? true)
            {
                Draw(camera, entity);
            }
        }

        DrawLanes(camera);
    }

    /// <inheritdoc/>
    public void Stop() => IsOn = false;

    private void DrawLanes(Camera camera)
    {
        if (_game.Roads is null)
        {
            return;
        }

        SeenEntity? ego = _sight.ReadEgo();
        Pose pose = ego?.Place.Pose ?? camera.Pose;
        Vector3D centre = ego?.Cuboid.Centre ?? pose.Position;
        if (_game.Roads.Near(centre) is not { } known)
        {
            return;
        }

        LaneObservation seen = known.Lanes.Observe(centre, Angles.HeadingDegrees(pose.Axes.Forward), 0, 0, [], _previous);
        _previous = seen.Match.HasRoad ? seen.Match : null;
        if (seen is not { Status: LaneStatus.Known, Stretch: { } stretch })
        {
            return;
        }

        double carOffset = seen.Match.LeftEdge + seen.Match.OffsetFromLeftEdge;
        foreach (
            LaneLineView view in LaneLineTracer
                .Trace(stretch, carOffset, 0, LaneReach)
                .SelectMany(line => LaneLineProjector.Project(camera, line, 0, null))
        )
        {
            DrawDots(view);
        }
    }

    /// <summary>Draws a line as dots at a minimum distance in the window: each costs a native, and far away many would coincide.</summary>
    private void DrawDots(LaneLineView line)
    {
        Vector2D? last = null;
        foreach (Vector2D place in line.Points.Select(point => new Vector2D(point.Pixel.X / Canvas.Width, point.Pixel.Y / Canvas.Height)))
        {
            if (last is not { } drawn || (place - drawn).Length >= DotFraction)
            {
                Fill(place.X, place.Y, 2 * LineFraction, 2 * LineFraction, Lanes);
                last = place;
            }
        }
    }

    private void Draw(Camera camera, SeenEntity entity)
    {
        Colour colour = entity.Model.Class switch
        {
            ObjectClass.Pedestrian or ObjectClass.Rider => People,
            ObjectClass.Sign or ObjectClass.TrafficLight => Signs,
            _ => Vehicles,
        };
        foreach (Cuboid cuboid in CuboidsOf(entity))
        {
            if (CuboidProjector.BoxesOf(camera, cuboid).Box is { } box)
            {
                Outline(box, colour);
            }
        }
    }

    private IEnumerable<Cuboid> CuboidsOf(SeenEntity entity)
    {
        IReadOnlyList<ModelFace> faces = _harvest.Faces.Of(entity.Model.Name);
        return faces.Count > 0 ? faces.Select(face => face.CuboidAt(entity.Place.Pose)) : [entity.Cuboid];
    }

    private void Outline(Box2D box, Colour colour)
    {
        double left = box.XMin / Canvas.Width;
        double top = box.YMin / Canvas.Height;
        double width = box.Width / Canvas.Width;
        double height = box.Height / Canvas.Height;
        double middleX = left + (width / 2);
        double middleY = top + (height / 2);
        Fill(middleX, top, width, LineFraction, colour);
        Fill(middleX, top + height, width, LineFraction, colour);
        Fill(left, middleY, LineFraction, height, colour);
        Fill(left + width, middleY, LineFraction, height, colour);
    }

    private void Fill(double centreX, double centreY, double width, double height, Colour colour) =>
        _display.Rectangle(new Box2D(centreX - (width / 2), centreY - (height / 2), centreX + (width / 2), centreY + (height / 2)), colour);
}
