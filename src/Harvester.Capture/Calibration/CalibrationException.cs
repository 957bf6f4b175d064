using System;

namespace Harvester.Capture.Calibration;

/// <summary>Ends a calibration with a message for the user. It never leaves the session.</summary>
internal sealed class CalibrationException(string message) : Exception(message);
