namespace Harvester.Sessions.Labels;

/// <summary>Whether a joint of a person is visible.</summary>
public enum JointVisibility
{
    /// <summary>Not determined: the rays or the time of the frame ran out, or the joint is beyond the reach of rays.</summary>
    Unknown,

    /// <summary>Outside the image or behind the camera.</summary>
    Outside,

    /// <summary>Hidden by another object or the world.</summary>
    Occluded,

    /// <summary>Hidden by another part of the same person.</summary>
    SelfOccluded,

    /// <summary>Visible: nothing but the body around the joint is in front of it.</summary>
    Visible,
}
