using Harvester.Sessions.Faces;

namespace Harvester.Capture.Labelling;

/// <summary>A part of an entity that is in the image, before it is known how much of it is hidden.</summary>
/// <param name="Space">The part.</param>
/// <param name="Face">Its entity, its own number and its place in the image.</param>
/// <param name="Parent">The entity's number.</param>
internal sealed record SpaceCandidate(SpaceOfInterest Space, LabelCandidate Face, int Parent);
