using Harvester.Sessions.Labels;

namespace Harvester.Capture.Harvesting;

/// <summary>The samples of the satellite receiver, which <see cref="GnssRecorder"/> takes in the ticks between frames.</summary>
internal sealed class GnssCapture() : CaptureChannel(FrameChannels.Gnss);
