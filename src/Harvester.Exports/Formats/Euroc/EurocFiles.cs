namespace Harvester.Exports.Formats.Euroc;

/// <summary>The files of a sequence in EuRoC's layout, and their first lines.</summary>
internal static class EurocFiles
{
    /// <summary>First line of the list of a camera's images.</summary>
    public const string ImageColumns = "#timestamp [ns],filename";

    /// <summary>First line of the samples of the inertial unit.</summary>
    public const string ImuColumns =
        "#timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],w_RS_S_z [rad s^-1],"
        + "a_RS_S_x [m s^-2],a_RS_S_y [m s^-2],a_RS_S_z [m s^-2]";

    /// <summary>First line of the true states.</summary>
    public const string StateColumns =
        "#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], q_RS_z [], "
        + "v_RS_R_x [m s^-1], v_RS_R_y [m s^-1], v_RS_R_z [m s^-1], b_w_RS_S_x [rad s^-1], b_w_RS_S_y [rad s^-1], b_w_RS_S_z [rad s^-1], "
        + "b_a_RS_S_x [m s^-2], b_a_RS_S_y [m s^-2], b_a_RS_S_z [m s^-2]";

    /// <summary>First line of the samples of the satellite receiver, which EuRoC itself does not have.</summary>
    public const string GnssColumns =
        "#timestamp [ns],latitude [deg],longitude [deg],altitude [m],v_east [m s^-1],v_north [m s^-1],v_up [m s^-1]";

    /// <summary>The folder of a sequence.</summary>
    public static string FolderOf(string split, string sequence) => $"{split}/{sequence}/mav0";

    /// <summary>The folder of a camera in that of its sequence.</summary>
    public static string Camera(int number) => $"cam{number}";

    /// <summary>The folder of the inertial unit.</summary>
    public const string Imu = "imu0";

    /// <summary>The folder of the satellite receiver.</summary>
    public const string Gnss = "gnss0";

    /// <summary>The folder of the true states.</summary>
    public const string States = "state_groundtruth_estimate0";

    /// <summary>The list in a folder.</summary>
    public const string Table = "data.csv";

    /// <summary>The description of a sensor in its folder.</summary>
    public const string Sensor = "sensor.yaml";
}
