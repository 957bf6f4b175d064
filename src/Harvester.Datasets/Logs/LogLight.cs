namespace Harvester.Datasets.Logs;

/// <summary>What a light tells a lane. The numbers are those of WOMD's lane states.</summary>
internal enum LogLight
{
    /// <summary>Not known.</summary>
    Unknown = 0,

    /// <summary>A red arrow.</summary>
    ArrowStop = 1,

    /// <summary>An amber arrow.</summary>
    ArrowCaution = 2,

    /// <summary>A green arrow.</summary>
    ArrowGo = 3,

    /// <summary>Red.</summary>
    Stop = 4,

    /// <summary>Amber.</summary>
    Caution = 5,

    /// <summary>Green.</summary>
    Go = 6,

    /// <summary>Flashing red.</summary>
    FlashingStop = 7,

    /// <summary>Flashing amber.</summary>
    FlashingCaution = 8,
}
