using Harvester.Sessions.Labels;

namespace Harvester.Capture.Harvesting;

/// <summary>The samples of the inertial unit, which <see cref="ImuRecorder"/> takes in the ticks between frames.</summary>
internal sealed class ImuCapture() : CaptureChannel(FrameChannels.Imu);
