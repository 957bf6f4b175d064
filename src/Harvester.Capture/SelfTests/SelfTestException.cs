namespace Harvester.Capture.SelfTests;

/// <summary>A check of the self-test cannot be made. The message completes the sentence "This was not tested: ".</summary>
internal sealed class SelfTestException(string message) : Exception(message);
