using Harvester.Sessions.Imaging;

namespace Harvester.Capture.SelfTests;

/// <summary>A picture that a self-test has taken.</summary>
/// <param name="Name">Its name without extension.</param>
/// <param name="Picture">Its pixels.</param>
public sealed record SelfTestPicture(string Name, PixelBuffer Picture);
