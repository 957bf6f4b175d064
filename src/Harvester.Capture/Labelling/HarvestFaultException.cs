using System;

namespace Harvester.Capture.Labelling;

/// <summary>Ends a harvest with a message for the user. It never leaves the session; a relabelling throws it to its caller.</summary>
public sealed class HarvestFaultException(string message) : Exception(message);
