using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>A picture and what is seen in it, agreed to be of one moment.</summary>
/// <param name="Snapshot">The state that the picture shows.</param>
/// <param name="LagFrames">Game frames from the reading of the state to the grab.</param>
/// <param name="LagSeconds">The same in seconds of the game's time.</param>
/// <param name="Picture">The picture, of the session's pool.</param>
/// <param name="Labelling">Objects and mask.</param>
internal sealed record FrameDraft(
    SceneSnapshot Snapshot, int LagFrames, double LagSeconds, PixelBuffer Picture, FrameLabelling Labelling);
