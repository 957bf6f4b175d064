using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>How well masks of two methods agree on the objects of a class.</summary>
/// <param name="Class">The class.</param>
/// <param name="Objects">Number of objects that were compared.</param>
/// <param name="MeanIou">Their mean intersection over union, 0 to 1.</param>
public sealed record MaskAgreement(ObjectClass Class, int Objects, double MeanIou);
