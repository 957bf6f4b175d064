using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Surveys.Faces;

/// <summary>A face marked by hand: two opposite corners of it, marked with the aiming ray. A third mark begins a new face.</summary>
/// <param name="prop">The prop that has the face.</param>
public sealed class HandMarking(EntityState prop)
{
    /// <summary>Minimum depth of a marked face, metres: both corners may lie exactly in its plane.</summary>
    private const double MinDepth = 0.02;

    /// <summary>Minimum width and height of a face, metres.</summary>
    private const double MinSide = 0.02;

    private readonly EntityState _prop = prop ?? throw new ArgumentNullException(nameof(prop));
    private Vector3D? _first;
    private Vector3D? _second;
    private Facing _facing;

    /// <summary>Whether both corners are marked, far enough apart for a face.</summary>
    public bool IsComplete => Corners is not null;

    /// <summary>The current cuboid, for drawing; null before the second mark.</summary>
    public Cuboid? Preview => Corners is { } corners ? Cuboid.FromModel(corners.Min, corners.Max, _prop.Pose) : null;

    private bool IsAcrossX => _facing is Facing.Back or Facing.Front;

    private (Vector3D Min, Vector3D Max)? Corners
    {
        get
        {
            if (_first is not { } a || _second is not { } b)
            {
                return null;
            }

            var min = new Vector3D(Math.Min(a.X, b.X), Math.Min(a.Y, b.Y), Math.Min(a.Z, b.Z));
            var max = new Vector3D(Math.Max(a.X, b.X), Math.Max(a.Y, b.Y), Math.Max(a.Z, b.Z));
            double width = IsAcrossX ? max.X - min.X : max.Y - min.Y;
            return width < MinSide || max.Z - min.Z < MinSide ? null : Deepened(min, max);
        }
    }

    /// <summary>Marks a corner of the face. After two corners, the next mark starts a new face.</summary>
    /// <param name="world">Where the aiming ray hits the prop, metres, world.</param>
    /// <param name="eye">Position of the camera, metres, world: the face looks to the camera's side of the model.</param>
    public void Mark(Vector3D world, Vector3D eye)
    {
        Vector3D corner = _prop.Pose.ToLocal(world);
        if (_first is null || _second is not null)
        {
            _first = corner;
            _second = null;
            Vector3D towards = _prop.Pose.ToLocal(eye) - corner;
            _facing =
                Math.Abs(towards.Y) >= Math.Abs(towards.X)
                    ? towards.Y < 0
                        ? Facing.Back
                        : Facing.Front
                    : towards.X < 0
                        ? Facing.Left
                        : Facing.Right;
        }
        else
        {
            _second = corner;
        }
    }

    /// <summary>The row of the marked face.</summary>
    /// <param name="name">What the sign says.</param>
    /// <param name="mutcdCode">Its code; empty if it has none or it is unknown.</param>
    /// <param name="face">Number of the face on its model, from 0.</param>
    /// <exception cref="InvalidOperationException">The corners are not both marked.</exception>
    public ModelFace ToSpace(string name, string mutcdCode, int face)
    {
        (Vector3D min, Vector3D max) = Corners ?? throw new InvalidOperationException("Mark two opposite corners of the face first.");
        bool isHashOnly = ModelHash.TryParse(_prop.Model, out int hash);
        return new ModelFace(
            isHashOnly ? string.Empty : _prop.Model,
            isHashOnly ? hash : ModelHash.Of(_prop.Model),
            _prop.Class == ObjectClass.TrafficLight ? ObjectClass.TrafficLight : ObjectClass.Sign,
            name,
            mutcdCode,
            face,
            new Vector3D(min.X, max.Y, max.Z),
            new Vector3D(max.X, min.Y, min.Z),
            _facing,
            Provenance.Measured,
            "marked by hand in the game"
        );
    }

    /// <summary>The corners with the minimum depth, extended behind the face.</summary>
    private (Vector3D Min, Vector3D Max) Deepened(Vector3D min, Vector3D max) =>
        _facing switch
        {
            Facing.Back => (min, max with { Y = Math.Max(max.Y, min.Y + MinDepth) }),
            Facing.Front => (min with { Y = Math.Min(min.Y, max.Y - MinDepth) }, max),
            Facing.Left => (min, max with { X = Math.Max(max.X, min.X + MinDepth) }),
            _ => (min with { X = Math.Min(min.X, max.X - MinDepth) }, max),
        };
}
