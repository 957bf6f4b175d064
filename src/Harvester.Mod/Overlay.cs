using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Scenes;
using Harvester.Capture.Spaces;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;

namespace Harvester.Mod;

/// <summary>Draws the boxes of the objects that would be labelled now, the faces of signs, and the lane lines over the game.</summary>
internal sealed class Overlay : IFeature
{
    private const double LineFraction = 0.0015;

    // The boxes are drawn in fractions of the window; any size of image will do.
    private static readonly ImageSize Canvas = new(1000, 1000);
    private static readonly Colour Vehicles = new(80, 220, 120, 255);
    private static readonly Colour People = new(255, 170, 60, 255);
    private static readonly Colour Signs = new(90, 170, 255, 255);
    private static readonly Colour Lanes = new(255, 255, 120, 255);
    private readonly ModSettings _settings;
    private readonly Messages _messages;
    private readonly IWorld _world;
    private readonly SpaceTable _spaces;
    private readonly Harvest _harvest;
    private bool _isOn;

    public Overlay(ModSettings settings, Messages messages, IWorld world, SpaceTable spaces, Harvest harvest)
    {
        _settings = settings;
        _messages = messages;
        _world = world;
        _spaces = spaces;
        _harvest = harvest;
    }

    /// <inheritdoc/>
    public string Name => "The overlay";

    /// <summary>Switches it on or off.</summary>
    public void Toggle()
    {
        string? problem = GameBuild.ListProblem;
        _isOn = !_isOn && problem is null;
        if (problem is not null)
        {
            _messages.Tell(problem);
        }
    }

    /// <inheritdoc/>
    public void Tick()
    {
        if (!_isOn || _harvest.IsPictureNear)
        {
            return;
        }

        HarvestOptions options = _settings.Options;
        CameraState state = _world.ReadCamera();
        var camera = new Camera(
            state.Pose, new CameraIntrinsics(state.VerticalFovDegrees, Canvas, state.WindowAspect, state.NearClip, options.Lens));
        foreach (EntityState entity in _world.ReadEntities(state.Pose.Position, options.RangeMetres))
        {
            if (options.Classes?.Contains(entity.Class) ?? true)
            {
                Draw(camera, entity);
            }
        }

        if (GameRoad.ClosestTo(state.Pose.Position) is { } road)
        {
            foreach (Projection point in LaneLines.Of(road, camera))
            {
                Natives.DrawRectangle(point.U / Canvas.Width, point.V / Canvas.Height, 2 * LineFraction, 2 * LineFraction, Lanes);
            }
        }
    }

    /// <inheritdoc/>
    public void Stop() => _isOn = false;

    private void Draw(Camera camera, EntityState entity)
    {
        Colour colour = entity.Class switch
        {
            ObjectClass.Pedestrian => People,
            ObjectClass.Sign or ObjectClass.TrafficLight => Signs,
            _ => Vehicles,
        };
        foreach (Cuboid cuboid in CuboidsOf(entity))
        {
            if (CuboidProjector.Project(camera, cuboid).Box is { } box)
            {
                Outline(box, colour);
            }
        }
    }

    private IEnumerable<Cuboid> CuboidsOf(EntityState entity)
    {
        IReadOnlyList<SpaceOfInterest> faces = _spaces.Of(entity.Model);
        return faces.Count > 0
            ? faces.Select(face => face.CuboidAt(entity.Pose))
            : [Cuboid.FromModel(entity.ModelMin, entity.ModelMax, entity.Pose)];
    }

    private static void Outline(Box2D box, Colour colour)
    {
        double left = box.XMin / Canvas.Width;
        double top = box.YMin / Canvas.Height;
        double width = box.Width / Canvas.Width;
        double height = box.Height / Canvas.Height;
        double middleX = left + (width / 2);
        double middleY = top + (height / 2);
        Natives.DrawRectangle(middleX, top, width, LineFraction, colour);
        Natives.DrawRectangle(middleX, top + height, width, LineFraction, colour);
        Natives.DrawRectangle(left, middleY, LineFraction, height, colour);
        Natives.DrawRectangle(left + width, middleY, LineFraction, height, colour);
    }
}
