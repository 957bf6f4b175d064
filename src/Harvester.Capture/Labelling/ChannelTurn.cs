namespace Harvester.Capture.Labelling;

/// <summary>When the turn of a channel comes in the labelling of a frame; the rays of the frame are spent in this order.</summary>
internal enum ChannelTurn
{
    /// <summary>After mask and objects.</summary>
    AfterObjects,

    /// <summary>After all labels.</summary>
    Last,
}
