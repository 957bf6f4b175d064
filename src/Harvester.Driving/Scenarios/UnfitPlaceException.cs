namespace Harvester.Driving.Scenarios;

/// <summary>A scenario cannot happen at a place; the message says why, as a sentence.</summary>
internal sealed class UnfitPlaceException(string message) : Exception(message);
