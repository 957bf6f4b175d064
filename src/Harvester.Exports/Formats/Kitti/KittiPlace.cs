namespace Harvester.Exports.Formats.Kitti;

/// <summary>Where a frame belongs among the cameras of KITTI's car.</summary>
/// <param name="Rig">The cameras.</param>
/// <param name="View">Number of its view in its moment, from 0; 0 without a rig.</param>
internal sealed record KittiPlace(KittiRig Rig, int View)
{
    /// <summary>The place of a frame.</summary>
    public static KittiPlace Of(ExportFrame frame)
    {
        KittiRig rig = KittiRig.Of(frame.Rig);
        return new KittiPlace(rig, frame.Rig is { } sensors ? frame.Label.Frame % sensors.Cameras.Count : 0);
    }

    /// <summary>Number of the camera, 0 to 3.</summary>
    public int Slot => Rig.SlotOf(View);

    /// <summary>Whether labels, points and calibration are written with this frame.</summary>
    public bool IsReference => Slot == KittiRig.Reference;

    /// <summary>Whether the motion of the moment is in the line of this frame.</summary>
    public bool IsFirst => View == 0 || !Rig.IsRectified;

    /// <summary>How many frames after this one the frame of the reference camera comes; negative if it comes before.</summary>
    public int ToReference => Rig.ViewOf(KittiRig.Reference) is { } reference ? reference - View : 0;
}
