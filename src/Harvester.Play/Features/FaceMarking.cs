using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Play.Surveys.Faces;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Features;

/// <summary>
/// Marks faces by hand: the player points the middle of the screen at two opposite corners of a face, sees the resulting cuboid, chooses a
/// name, and saves it with the measured faces.
/// </summary>
public sealed class FaceMarking : ILastingFeature
{
    private const double ReachMetres = 50;
    private static readonly Colour Marked = new(255, 90, 200);
    private readonly GamePorts _game;
    private readonly IProps _props;
    private readonly IReadOnlyList<SignName> _names;
    private readonly FaceTable _shipped;
    private readonly MeasuredFaces _measured;
    private readonly IDisplay _display;
    private readonly PlayerMessages _messages;
    private HandMarking? _marking;
    private EntityState? _prop;
    private int _name;

    /// <summary>Creates the feature; it is off.</summary>
    /// <param name="game">The game.</param>
    /// <param name="props">The props that can be marked.</param>
    /// <param name="names">The names to choose from; at least one.</param>
    /// <param name="shipped">The shipped faces: when a model is marked for the first time, its faces on other sides are kept.</param>
    /// <param name="measured">Receives the rows.</param>
    /// <param name="display">Draws the cuboid.</param>
    /// <param name="messages">Reports the result.</param>
    public FaceMarking(
        GamePorts game,
        IProps props,
        IReadOnlyList<SignName> names,
        FaceTable shipped,
        MeasuredFaces measured,
        IDisplay display,
        PlayerMessages messages
    )
    {
        _game = game;
        _props = props;
        _names = names;
        _shipped = shipped;
        _measured = measured;
        _display = display;
        _messages = messages;
    }

    /// <inheritdoc/>
    public string Name => "Marking by hand";

    /// <inheritdoc/>
    public bool IsOn => _prop is not null;

    /// <inheritdoc/>
    public bool IsBusy => _measured.IsBusy;

    /// <summary>Whether a harvest is running, which keeps the faces with which it began.</summary>
    public Func<bool> IsHarvesting { get; init; } = static () => false;

    /// <summary>Whether nothing may be drawn now.</summary>
    public Func<bool> IsPictureNear { get; init; } = static () => false;

    /// <summary>A line about the face that is being marked; null if there is none.</summary>
    public string? Line =>
        _prop is { } prop
            ? $"FACE  {prop.Model}  {_names[_name]}{(_marking!.IsComplete ? string.Empty : "  mark the opposite corner")}"
            : null;

    /// <summary>Marks a corner at the middle of the screen.</summary>
    public void Mark()
    {
        _measured.Open();
        Pose eye = _game.World.ReadCamera().Pose;
        var ray = new Ray(eye.Position, eye.Axes.Forward);
        if (
            _game.Rays.Cast(ray, ReachMetres, _props.PlayersBody) is not { } hit
            || hit.Entity == RayHit.World
            || _props.ReadProp(hit.Entity) is not { } prop
        )
        {
            _messages.Tell("There is no prop in the middle of the screen. Go nearer and aim at the face itself.");
            return;
        }

        if (_marking is null || _prop!.Handle != prop.Handle)
        {
            _prop = prop;
            _marking = new HandMarking(prop);
        }

        _marking.Mark(ray.At(hit.Distance), eye.Position);
    }

    /// <summary>Chooses the next name.</summary>
    public void NextName() => _name = (_name + 1) % _names.Count;

    /// <summary>Saves the marked face. It replaces a face of the player's that it overlaps.</summary>
    public void Keep()
    {
        if (_marking is not { IsComplete: true } marking)
        {
            _messages.Tell("Mark two opposite corners of a face first.");
            return;
        }

        if (_measured.Open() is not { } folder)
        {
            _messages.Tell("Earlier measurements are still being read. Try again in a moment.");
            return;
        }

        string model = _prop!.Model;
        SignName name = _names[_name];
        ModelFace face = marking.ToSpace(name.Name, name.MutcdCode, 0);
        IReadOnlyList<ModelFace> own = folder.Table.Of(face.Hash);
        ModelFace[] earlier = [.. own.Count > 0 ? own : _shipped.Of(face.Hash).Where(other => other.Facing != face.Facing)];
        ModelFace? replaced = earlier.FirstOrDefault(other => Overlap(other, face));
        face = face with { Number = replaced?.Number ?? KeptFaces.FreeNumber(earlier) };
        folder.Finish(model, "byHand", [.. earlier.Where(other => other.Number != face.Number), face]);
        string start = IsHarvesting() ? "from the next harvest" : "from now";
        _messages.Tell(
            FormattableString.Invariant($"Saved: face {face.Number} of {model}, {name}, in {_measured.Path}. It is in use {start} on.")
        );
        Stop();
    }

    /// <inheritdoc/>
    public void Tick()
    {
        if (_prop is null || IsPictureNear())
        {
            return;
        }

        var canvas = new WindowCanvas(_display, _game.World.ReadCamera());
        canvas.Cross(Marked);
        if (_marking!.Preview is { } preview)
        {
            canvas.Edges(preview, Marked);
        }
    }

    /// <inheritdoc/>
    public void Stop()
    {
        _marking = null;
        _prop = null;
    }

    /// <inheritdoc/>
    public void Finish()
    {
        Stop();
        _measured.Wait();
    }

    private static bool Overlap(ModelFace one, ModelFace other)
    {
        (Vector3D aLow, Vector3D aHigh) = Corners(one);
        (Vector3D bLow, Vector3D bHigh) = Corners(other);
        return one.Facing == other.Facing
            && aLow.X < bHigh.X
            && bLow.X < aHigh.X
            && aLow.Y <= bHigh.Y
            && bLow.Y <= aHigh.Y
            && aLow.Z < bHigh.Z
            && bLow.Z < aHigh.Z;
    }

    private static (Vector3D Low, Vector3D High) Corners(ModelFace face) =>
        (
            new(face.FrontUpperLeft.X, face.BackLowerRight.Y, face.BackLowerRight.Z),
            new(face.BackLowerRight.X, face.FrontUpperLeft.Y, face.FrontUpperLeft.Z)
        );
}
