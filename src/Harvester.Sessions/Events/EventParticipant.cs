using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Events;

/// <summary>A road user of an event, as it was at the event's peak.</summary>
/// <param name="Object">Its id, the same as in labels, 1 to 65,535; null for the ego.</param>
/// <param name="Class">Its class; null for the ego.</param>
/// <param name="Model">The game's name of its model.</param>
/// <param name="Pose">Position of the model's origin and orientation, metres, world.</param>
/// <param name="ModelMin">Rear, left, lower corner of the model's box in its own frame, metres.</param>
/// <param name="ModelMax">Front, right, upper corner of the model's box in its own frame, metres.</param>
/// <param name="Velocity">Metres per second, world.</param>
/// <param name="YawRate">Turning rate about the vertical, rad/s, positive to the left.</param>
public sealed record EventParticipant(
    int? Object,
    ObjectClass? Class,
    string Model,
    Pose Pose,
    Vector3D ModelMin,
    Vector3D ModelMax,
    Vector3D Velocity,
    double YawRate
);
