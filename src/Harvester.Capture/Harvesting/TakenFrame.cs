using Harvester.Capture.Labelling;

namespace Harvester.Capture.Harvesting;

/// <summary>A frame that a flow has taken.</summary>
/// <param name="Draft">Its scene and labels.</param>
/// <param name="Picture">Its picture, which belongs to the frame.</param>
internal sealed record TakenFrame(FrameDraft Draft, GrabbedPicture Picture);
