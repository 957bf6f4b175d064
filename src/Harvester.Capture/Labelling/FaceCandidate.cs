using Harvester.Sessions.Faces;

namespace Harvester.Capture.Labelling;

/// <summary>A face of an entity that is in the image, before its occlusion is known.</summary>
/// <param name="Face">The face on its model.</param>
/// <param name="Seen">Its entity, its own id and its projection.</param>
/// <param name="Parent">The id of the entity.</param>
internal sealed record FaceCandidate(ModelFace Face, LabelCandidate Seen, int Parent);
