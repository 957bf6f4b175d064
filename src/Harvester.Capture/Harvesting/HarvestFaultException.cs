using System;

namespace Harvester.Capture.Harvesting;

/// <summary>Ends a harvest with a message for the user. It never leaves the session.</summary>
internal sealed class HarvestFaultException(string message) : Exception(message);
