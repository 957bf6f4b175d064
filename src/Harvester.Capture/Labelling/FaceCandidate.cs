using Harvester.Sessions.Faces;

namespace Harvester.Capture.Labelling;

/// <summary>A face of an entity that is in the image, before it is known how much of it is hidden.</summary>
/// <param name="Face">The face on its model.</param>
/// <param name="Seen">Its entity, its own number and its place in the image.</param>
/// <param name="Parent">The entity's number.</param>
internal sealed record FaceCandidate(ModelFace Face, LabelCandidate Seen, int Parent);
